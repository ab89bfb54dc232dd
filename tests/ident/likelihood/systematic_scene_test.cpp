// Scenes with [[data.gains]] and [[data.masses]]: what is estimated, what it costs, what is found without them.
#include <gmock/gmock.h>

#include <cmath>

#include "base/error.hpp"
#include "ident/scene/read_scene.hpp"
#include "tests/ident/likelihood_case.hpp"
#include "study/systematic_noise.hpp"
#include "tasks/bound.hpp"

namespace jointid::ident {
namespace {

using ::testing::HasSubstr;

Solution solved(const Scene& scene, problems::Measurement measurement, Detail detail = Detail::estimates) {
  Control control;
  control.threads = 1;
  control.detail = detail;
  control.judgement = Judgement::fit;
  return solve(*problems::plan(scene, std::move(measurement)), control);
}

/// FRFs there and back with noise of their own.
problems::Measurement measured(const LikelihoodCase& of, std::uint64_t seed) {
  problems::Problem problem = of.problem;
  if (auto* noise = std::get_if<frf::NoiseModel>(&problem.noise)) noise->reciprocal = false;
  return problems::polluted(problem, seed, 0);
}

/// The row of a response times a factor.
void scale(frf::FrfSet& set, const char* name, double factor) {
  const std::size_t row = frf::find_coordinate(set.header.response, frf::Dof::parse(name));
  ASSERT_NE(row, frf::npos);
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) set.values[set.index(line, row, c)] *= factor;
  }
}

GainPrior gains(double deviation, std::vector<frf::Dof> dofs = {}) {
  return {.dofs = std::move(dofs), .files = {{0, 1}, {0}}, .gain = deviation};
}

void expect_same(const Solution& a, const Solution& b, double errors) {
  ASSERT_EQ(a.unknowns.size(), b.unknowns.size());
  for (std::size_t i = 0; i < a.unknowns.size(); ++i) {
    const double error = *b.unknowns[i].std_error;
    EXPECT_NEAR(a.unknowns[i].value, b.unknowns[i].value, errors * error) << a.unknowns[i].name;
    EXPECT_NEAR(*a.unknowns[i].std_error, error, 0.01 * error) << a.unknowns[i].name;
  }
}

TEST(SystematicScene, KnownGainsChangeNothing) {
  LikelihoodCase a1("A1", 0.01);
  a1.scene.data.gains = {gains(0.0)};
  const Solution without = solved(a1.scene, measured(a1, 1));
  a1.scene.data.gains = {gains(1e-9)};
  const Solution with = solved(a1.scene, measured(a1, 1));
  EXPECT_TRUE(without.systematic.empty());
  EXPECT_FALSE(with.systematic.empty());
  expect_same(with, without, 0.01);
}

TEST(SystematicScene, AFreeGainTakesUpWhatASensorIsOff) {
  LikelihoodCase a1("A1", 0.01);
  const std::string sensor = a1.problem.assembly.header.response.front().name();
  a1.scene.data.gains = {{.dofs = {frf::Dof::parse(sensor)}, .files = {{}, {0}}, .gain = 100.0}};
  problems::Measurement right = measured(a1, 2), wrong = right;
  scale(wrong.assembly, sensor.c_str(), 1.0 / 1.05);
  const Solution one = solved(a1.scene, std::move(right)), other = solved(a1.scene, std::move(wrong));
  ASSERT_EQ(one.systematic.size(), 1U);
  EXPECT_EQ(one.systematic[0].name, "gain of " + sensor);
  EXPECT_NEAR(other.systematic[0].value / one.systematic[0].value, 1.05, 2e-3);
  EXPECT_NEAR(one.systematic[0].value, 1.0, 4.0 * *one.systematic[0].std_error);
  expect_same(other, one, 0.3);
}

TEST(SystematicScene, PriorsCostPrecisionAndTheBoundKnows) {
  LikelihoodCase a1("A1", 0.01);
  std::vector<double> truth;
  for (const auto& unknown : a1.problem.unknowns) truth.push_back(unknown.value);
  const std::vector<double> without = tasks::cramer_rao_bound(*a1.clean(), truth, {});
  a1.scene.data.gains = {gains(0.01)};
  const std::vector<double> with = tasks::cramer_rao_bound(*a1.clean(), truth, {});
  for (std::size_t i = 0; i < truth.size(); ++i) EXPECT_GT(with[i], without[i] * (1.0 - 1e-9));
  EXPECT_GT(with[0], 1.2 * without[0]);
}

TEST(SystematicScene, IntervalsHoldWithPriors) {
  LikelihoodCase a1("A1", 0.01);
  a1.scene.frequency.step_hz = 40.0;
  const study::SystematicNoise noise{.gain = 0.01, .mass = 0.0};
  Scene with = a1.scene;
  with.data.gains = {gains(0.01)};
  std::size_t inside = 0, inside_without = 0, count = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    problems::Measurement data{a1.problem.substructures, a1.problem.assembly};
    const auto spoil = [&](frf::FrfSet& set, std::uint64_t number) {
      noise.apply(set, {seed, 0, 0});
      auto model = std::get<frf::NoiseModel>(a1.problem.noise);
      model.reciprocal = false;
      set = frf::polluted(set, model, seed, 0, number);
    };
    for (std::size_t i = 0; i < data.substructures.size(); ++i) spoil(data.substructures[i], i);
    spoil(data.assembly, 7);
    const Solution good = solved(with, data), bad = solved(a1.scene, data);
    for (std::size_t i = 0; i < good.unknowns.size(); ++i) {
      const double truth = a1.problem.unknowns[i].value;
      const auto holds = [&](const Solution& of) {
        return (*of.unknowns[i].ci95)[0] <= truth && truth <= (*of.unknowns[i].ci95)[1];
      };
      if (truth == 0.0 || !good.unknowns[i].ci95) continue;
      ++count;
      inside += holds(good) ? 1U : 0U;
      inside_without += bad.unknowns[i].ci95 && holds(bad) ? 1U : 0U;
    }
  }
  EXPECT_GE(static_cast<double>(inside), 0.85 * static_cast<double>(count));
  EXPECT_LT(inside_without, inside);
}

/// A coordinate is called another direction of another one's node, so that there is another axis.
void rename(frf::FrfSet& set, const frf::Dof& from, const frf::Dof& to) {
  for (std::vector<frf::Dof>* dofs : {&set.header.response, &set.header.reference}) {
    for (frf::Dof& dof : *dofs) {
      if (dof.same_coordinate(from)) dof = to;
    }
  }
}

TEST(SystematicScene, AnAngleTowardsAnotherAxisIsFound) {
  LikelihoodCase a1("A1", 0.01);
  constexpr double angle = 0.05;
  const frf::Dof sensor = a1.problem.assembly.header.response[0];
  const auto& responses = a1.problem.assembly.header.response;
  const auto is_other = [&](const frf::Dof& dof) { return !dof.is_rotation() && dof.node != sensor.node; };
  const frf::Dof other = *std::ranges::find_if(responses, is_other);
  const frf::Dof turned{sensor.node, frf::Direction::z};
  for (frf::FrfSet& set : a1.problem.substructures) rename(set, other, turned);
  rename(a1.problem.assembly, other, turned);
  problems::Measurement data = measured(a1, 3);
  frf::FrfSet& set = data.assembly;
  const std::size_t row = frf::find_coordinate(set.header.response, sensor), along = frf::find_coordinate(set.header.response, turned);
  ASSERT_FALSE(sensor.is_rotation());
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    for (std::size_t c = 0; c < set.header.reference.size(); ++c) {
      set.values[set.index(line, row, c)] += angle * set.values[set.index(line, along, c)];
    }
  }
  a1.scene.data.gains = {{.dofs = {sensor}, .files = {{}, {0}}, .angle = 0.1}};
  const Solution found = solved(a1.scene, std::move(data));
  ASSERT_EQ(found.systematic.size(), 1U);
  EXPECT_EQ(found.systematic[0].name, "angle towards Z of " + sensor.name());
  EXPECT_NEAR(found.systematic[0].value, angle, 4.0 * *found.systematic[0].std_error);
  EXPECT_LT(*found.systematic[0].std_error, 0.2 * angle);
}

TEST(SystematicScene, AnAngleNeedsAnotherAxis) {
  LikelihoodCase a1("A1", 0.01);
  a1.scene.data.gains = {{.dofs = {}, .files = {{0, 1}, {0}}, .angle = 0.1}};
  try {
    (void)a1.clean();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no sensor of the table has another direction"));
  }
}

TEST(SystematicScene, ASensorThatIsOffIsNamed) {
  const LikelihoodCase rig("rig1");
  problems::Measurement data = problems::polluted(rig.problem, 1, 0);
  scale(data.assembly, "125:+Y", 1.0 / 1.02);
  Scene scene = rig.scene;
  scene.noise.reset();
  scene.frequency.step_hz = 12.0;
  const Solution found = solved(scene, data, Detail::full);
  ASSERT_TRUE(tells(found, FindingKind::gain));
  const auto& findings = found.identifiability->findings;
  const auto gain = std::ranges::find(findings, FindingKind::gain, &Finding::kind);
  EXPECT_THAT(gain->text, HasSubstr("125:+Y"));
}

}  // namespace
}  // namespace jointid::ident
