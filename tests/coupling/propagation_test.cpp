#include "coupling/propagation.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "in_memory_parts.hpp"
#include "problems/case/coupling_problem.hpp"

namespace jointid::coupling {
namespace {

/// Mean and variances over draws of what comes out, against what was predicted: rms of the quotients.
struct Compared {
  double mean_quotient = 0.0, largest = 0.0, smallest = HUGE_VAL;
};

frf::FrfSet some_lines(const frf::FrfSet& set, const std::vector<std::size_t>& lines) {
  auto source = frf::from_memory(set);
  std::vector<std::size_t> all(set.header.response.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  return frf::load(*source, {lines, all, all});
}

Compared monte_carlo(const problems::CouplingProblem& problem, const Assembly& assembly, const frf::NoiseModel& noise,
                     const Options& options) {
  const std::vector<std::size_t> lines = {20, 60, 90, 140};
  std::vector<frf::FrfSet> clean;
  for (const frf::FrfSet& part : problem.parts) clean.push_back(some_lines(part, lines));
  Options with = options, without = options;
  with.uncertainty = true;
  with.noise = noise;
  without.threads = with.threads = 1;
  // From data with errors, as a user has them: whether an FRF and its transpose share theirs, shows there only.
  std::vector<frf::FrfSet> measured;
  for (std::size_t i = 0; i < clean.size(); ++i) measured.push_back(frf::polluted(clean[i], noise, 3, 0, i));
  const frf::FrfSet predicted = couple_all(problems::parts_of(problem, measured), assembly, with);
  const frf::FrfSet centre = couple_all(problems::parts_of(problem, clean), assembly, without);
  std::vector<double> re(centre.values.size(), 0.0), im(re);
  constexpr std::size_t draws = 3000;
  for (std::size_t t = 0; t < draws; ++t) {
    std::vector<frf::FrfSet> sets;
    for (std::size_t i = 0; i < clean.size(); ++i) sets.push_back(frf::polluted(clean[i], noise, 7, t, i));
    const frf::FrfSet drawn = couple_all(problems::parts_of(problem, sets), assembly, without);
    for (std::size_t i = 0; i < re.size(); ++i) {
      const Complex d = drawn.values[i] - centre.values[i];
      re[i] += d.real() * d.real() / draws;
      im[i] += d.imag() * d.imag() / draws;
    }
  }
  Compared out;
  for (std::size_t i = 0; i < re.size(); ++i) {
    for (const double quotient : {re[i] / predicted.variance[i].real(), im[i] / predicted.variance[i].imag()}) {
      out.mean_quotient += quotient / static_cast<double>(2 * re.size());
      out.largest = std::max(out.largest, quotient);
      out.smallest = std::min(out.smallest, quotient);
    }
  }
  return out;
}

/// 3000 draws give a variance to ±2.6 % (1σ); the largest of 200 lies within ±12 %.
void expect_as_drawn(const Compared& found) {
  EXPECT_NEAR(found.mean_quotient, 1.0, 0.03);
  EXPECT_LT(found.largest, 1.15);
  EXPECT_GT(found.smallest, 0.86);
}

TEST(Propagation, IndependentErrorsAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  expect_as_drawn(monte_carlo(problem, problem.declared(), {.kind = frf::NoiseKind::circular, .level = 1e-4, .reciprocal = false}, {}));
}

TEST(Propagation, ErrorsThatAnFrfAndItsTransposeShareAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-B");
  expect_as_drawn(monte_carlo(problem, problem.declared(), {.kind = frf::NoiseKind::uniform, .level = 1e-4}, {.method = Method::pcc}));
}

TEST(Propagation, WithAJointAndErrorsByPartTheyAreAsDrawn) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  Assembly assembly = problem.declared();
  assembly.join.pop_back();
  assembly.joints.push_back({.dofs = {placed("4:+Y"), placed("7:+Y")}, .stiffness = {5e4, -5e4, -5e4, 5e4}, .mass = {},
                             .viscous_damping = {40.0, -40.0, -40.0, 40.0}, .hysteretic_damping = {}});
  expect_as_drawn(monte_carlo(problem, assembly, {.kind = frf::NoiseKind::gaussian, .level = 1e-4}, {.method = Method::mtc}));
}

TEST(Propagation, AnUnknownVarianceStaysWhereItBelongs) {
  const problems::CouplingProblem problem = problems::make_coupling("coupling-A");
  std::vector<frf::FrfSet> sets;
  for (const frf::FrfSet& part : problem.parts) {
    sets.push_back(some_lines(part, {30}));
    sets.back().header.noise = frf::NoiseRecord::variance;
    sets.back().variance.assign(sets.back().values.size(), Complex(1e-20, 1e-20));
  }
  sets[0].variance[0] = Complex(std::nan(""), std::nan(""));  // H_11, and 1 is not coupled
  const frf::FrfSet found = couple_all(problems::parts_of(problem, sets), problem.declared(), {.uncertainty = true});
  EXPECT_TRUE(std::isnan(found.variance[0].real()));
  for (std::size_t i = 1; i < found.variance.size(); ++i) EXPECT_GT(found.variance[i].real(), 0.0) << i;
}

}  // namespace
}  // namespace jointid::coupling
