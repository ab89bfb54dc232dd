// What the errors of an identified joint have in common with those of the parts' FRFs, and what a coupling makes of it.
#include "ident/likelihood/findings/joint_errors.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "coupling/assembly_reader.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tasks/identified_joint.hpp"

namespace jointid::ident {
namespace {

constexpr double error_level = 1e-4;

Scene scene_by_likelihood(const problems::Problem& problem) {
  Scene scene = problems::scene(problem);
  scene.identify.method = Method::likelihood;
  scene.frequency.step_hz = 60.0;
  scene.noise.reset();
  return scene;
}

/// Exact FRFs that say of relative errors.
problems::Measurement exact_with_errors(const problems::Problem& problem) {
  problems::Measurement out{problem.substructures, problem.assembly};
  const auto tell = [](frf::FrfSet& set) {
    set.coherence.clear();
    set.header.noise = frf::NoiseRecord::variance;
    set.header.averages = 0.0;
    set.variance.clear();
    for (const Complex& value : set.values) {
      const double half = 0.5 * error_level * error_level * std::norm(value);
      set.variance.emplace_back(half, half);
    }
  };
  for (frf::FrfSet& set : out.substructures) tell(set);
  tell(out.assembly);
  return out;
}

std::vector<double> found_values(const Solution& solution) {
  std::vector<double> out;
  for (const Estimate& unknown : solution.unknowns) out.push_back(unknown.value);
  return out;
}

/// E[ε θ] of one FRF is its variance times what the joint moves by when the FRF does.
TEST(JointErrors, AreWhatTheJointMovesByWhenAnFrfDoes) {
  const problems::Problem problem = problems::make("A1");
  const Scene scene = scene_by_likelihood(problem);
  const problems::Measurement data = exact_with_errors(problem);
  const auto plan = problems::plan(scene, data);
  const std::vector<double> values = found_values(solve(*plan));
  const JointErrors errors = joint_errors(*plan, values);
  ASSERT_EQ(errors.frequency_hz.size(), plan->lines.size());
  const std::size_t line = plan->lines.size() / 2, part = 0;
  const frf::FrfSet& set = data.substructures[part];
  std::size_t told = 0;
  for (std::size_t r = 0; r < set.header.response.size(); ++r) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      const std::size_t row = frf::find_coordinate(errors.coordinates, set.header.response[r]),
                        column = frf::find_coordinate(errors.coordinates, set.header.reference[c]);
      const std::size_t back_row = frf::find_coordinate(set.header.response, set.header.reference[c]),
                        back_column = frf::find_coordinate(set.header.reference, set.header.response[r]);
      if (row == frf::npos || column == frf::npos || back_row < r) continue;
      for (const Complex turn : {Complex(1.0), Complex(0.0, 1.0)}) {
        problems::Measurement moved = data;
        const std::size_t at = set.index(plan->lines[line].substructures, r, c);
        const Complex step = 0.3 * error_level * std::abs(set.values[at]) * turn;
        moved.substructures[part].values[at] += step;
        if (back_row != r && back_row != frf::npos && back_column != frf::npos) {
          moved.substructures[part].values[set.index(plan->lines[line].substructures, back_row, back_column)] += step;
        }
        const std::vector<double> there = found_values(solve(*problems::plan(scene, moved)));
        const double variance = 0.5 * error_level * error_level * std::norm(set.values[at]);
        for (std::size_t m = 0; m < values.size(); ++m) {
          const Complex common = errors.common[line][frf::pair_index(std::max(row, column), std::min(row, column)) * values.size() + m];
          const double expected = variance * (there[m] - values[m]) / std::abs(step),
                       stated = turn.real() != 0.0 ? common.real() : common.imag();
          const double deviation = std::sqrt(variance * errors.covariance(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(m)));
          EXPECT_NEAR(stated, expected, 2e-3 * deviation)
              << set.header.response[r].name() << "/" << set.header.reference[c].name() << " " << m;
          told += std::abs(expected) > 0.02 * deviation ? 1U : 0U;
        }
      }
    }
  }
  EXPECT_GT(told, 10u);
}

TEST(JointErrors, OfWhatIsNotCarriedAreAnError) {
  const problems::Problem problem = problems::make("A1");
  Scene scene = scene_by_likelihood(problem);
  scene.identify.method = Method::one;
  const auto plan = problems::plan(scene, exact_with_errors(problem));
  const std::vector<double> values = found_values(solve(*plan));
  try {
    (void)joint_errors(*plan, values);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("only method \"likelihood\" gives the errors that a joint shares"));
  }
}

/// Variances of FRFs coupled with an identified joint, against differences by every number that the parts and the joint come from: the
/// joint moves as the one of the test above does.
TEST(JointErrors, GoThroughTheCouplingAsDifferencesSay) {
  const problems::Problem problem = problems::make("A1");
  const Scene scene = scene_by_likelihood(problem);
  const problems::Measurement data = exact_with_errors(problem);
  const auto plan = problems::plan(scene, data);
  const Solution solution = solve(*plan);
  std::vector<std::string> names;
  for (std::size_t i = 0; i < data.substructures.size(); ++i) names.push_back("p" + std::to_string(i));
  const coupling::KnownJoint joint = tasks::identified_joint(*plan, solution, {}, names, true);
  const auto reader_of = [&](const coupling::KnownJoint& with) {
    std::vector<coupling::Part> parts;
    for (std::size_t i = 0; i < names.size(); ++i) {
      std::vector<std::unique_ptr<frf::FrfSource>> sources;
      sources.push_back(frf::from_memory(data.substructures[i]));
      parts.push_back({names[i], std::make_shared<frf::FrfSystem>(names[i], std::move(sources), frf::Composition::merged, false)});
    }
    coupling::Assembly assembly;
    assembly.joints = {with};
    return coupling::AssemblyReader(std::move(parts), assembly, {.uncertainty = true, .threads = 1}, "test");
  };
  coupling::AssemblyReader with = reader_of(joint);
  EXPECT_TRUE(with.has_covariance());
  const std::vector<std::size_t> line = {plan->lines[plan->lines.size() / 2].substructures}, one = {0};
  // The joint alone: D C Dᵀ by differences of the unknowns.
  const std::size_t p = joint.uncertainty->unknowns.size();
  coupling::KnownJoint alone = joint;
  auto without = std::make_shared<coupling::JointUncertainty>(*joint.uncertainty);
  without->common = nullptr;
  alone.uncertainty = without;
  coupling::KnownJoint certain = joint;
  certain.uncertainty = nullptr;
  const auto variance_of = [&](const coupling::KnownJoint& of) {
    Complex value, variance;
    reader_of(of).read({line, one, one}, {&value, 1}, {&variance, 1});
    return std::pair(value, variance);
  };
  std::vector<Complex> by;
  for (std::size_t m = 0; m < p; ++m) {
    const double step = 1e-2 * std::sqrt(joint.uncertainty->covariance[m * p + m]);
    const auto moved = [&](double way) {
      coupling::KnownJoint there = certain;
      const auto add = [&](std::vector<double>& to, const std::vector<double>& of) {
        for (std::size_t i = 0; i < of.size(); ++i) to[i] += way * of[i];
      };
      const coupling::JointUncertainty::Unknown& unknown = joint.uncertainty->unknowns[m];
      add(there.stiffness, unknown.stiffness);
      add(there.mass, unknown.mass);
      add(there.viscous_damping, unknown.viscous_damping);
      add(there.hysteretic_damping, unknown.hysteretic_damping);
      return variance_of(there).first;
    };
    by.push_back((moved(step) - moved(-step)) / (2.0 * step));
  }
  double re = 0.0, im = 0.0;
  for (std::size_t m = 0; m < p; ++m) {
    for (std::size_t n = 0; n < p; ++n) {
      re += by[m].real() * joint.uncertainty->covariance[m * p + n] * by[n].real();
      im += by[m].imag() * joint.uncertainty->covariance[m * p + n] * by[n].imag();
    }
  }
  const Complex added = variance_of(alone).second - variance_of(certain).second;
  EXPECT_NEAR(added.real(), re, 1e-4 * re);
  EXPECT_NEAR(added.imag(), im, 1e-4 * im);
  // With what it shares the prediction is another one, and no variance is below zero.
  const Complex shared = variance_of(joint).second;
  EXPECT_GT(shared.real(), 0.0);
  EXPECT_GT(shared.imag(), 0.0);
  EXPECT_NE(shared, variance_of(alone).second);
}

}  // namespace
}  // namespace jointid::ident
