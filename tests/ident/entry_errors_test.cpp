#include "tasks/entry_errors.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/planted.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

struct SolvedProblem {
  std::unique_ptr<Plan> plan;
  Solution solution;
};

SolvedProblem solved_problem(const std::string& name) {
  const problems::Problem problem = problems::make(name);
  SolvedProblem out{problems::plan(problems::scene(problem), {problem.substructures, problem.assembly}), {}};
  out.solution = ident::solve(*out.plan);
  return out;
}

/// A joint 1.5 times as stiff as the right one.
SolvedProblem too_stiff(const std::string& name) {
  SolvedProblem out = solved_problem(name);
  for (auto& [kind, matrix] : out.solution.bands.front().matrices) {
    for (auto& row : matrix) {
      for (double& value : row) value *= 1.5;
    }
  }
  return out;
}

TEST(EntryErrors, NoiseFreeDataHaveNone) {
  SolvedProblem a1 = solved_problem("A1");
  const tasks::EntryErrors errors = tasks::entry_errors(*a1.plan, a1.solution.bands);
  EXPECT_EQ(errors.responses.size(), errors.all_responses);
  ASSERT_EQ(errors.rms_db.size(), errors.responses.size() * errors.references.size());
  for (const double error : errors.rms_db) EXPECT_LE(error, 1e-4);
}

double size_of(const tasks::RegeneratedFrf& frf) {
  double largest = 0.0;
  for (const Complex& value : frf.measured) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Second route: one FRF after the other by regenerate().
TEST(EntryErrors, AreThoseOfTheFrfsRegeneratedOneByOne) {
  for (const char* name : {"A1", "B"}) {
    SolvedProblem problem = too_stiff(name);
    const tasks::EntryErrors errors = tasks::entry_errors(*problem.plan, problem.solution.bands);
    const tasks::Regenerated all =
        tasks::regenerate(*problem.plan, problem.solution.bands, tasks::choose_entries(*problem.plan, 100000));
    double largest = 0.0;
    for (const tasks::RegeneratedFrf& frf : all.frfs) {
      const std::size_t row = frf::find_coordinate(errors.responses, frf.entry.response);
      const std::size_t column = frf::find_coordinate(errors.references, frf.entry.reference);
      const double error = errors.rms_db[row * errors.references.size() + column];
      if (std::isnan(error)) {
        EXPECT_LT(size_of(frf), 1e-9 * size_of(all.frfs.front())) << "left out though it does not vanish by symmetry";
        continue;
      }
      EXPECT_NEAR(error, tasks::decibel_error(frf).value(), 1e-9)
          << name << " " << frf.entry.response.name() << "/" << frf.entry.reference.name();
      largest = std::max(largest, error);
    }
    EXPECT_EQ(all.frfs.size(), errors.rms_db.size());
    EXPECT_GT(largest, 0.5) << name;
  }
}

/// Of the right joint and noisy FRFs of parts and assembly: noise explains all of it.
TEST(EntryErrors, InUnitsOfNoiseAreOneWhereNoiseIsAll) {
  problems::Problem problem = problems::make("A1");
  problem.noise = frf::NoiseModel{.kind = frf::NoiseKind::circular, .level = 0.002};
  Scene scene = problems::scene(problem);
  scene.noise = NoiseSection{.model = "circular", .level = 0.002, .frf_model = std::get<frf::NoiseModel>(problem.noise)};
  scene.identify.variance = VarianceChoice::noise;
  const SolvedProblem exact = solved_problem("A1");
  double sum = 0.0, count = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const auto plan = problems::plan(scene, problems::polluted(problem, seed, 0));
    for (const double error : tasks::entry_errors(*plan, exact.solution.bands).rms_noise) {
      if (!std::isfinite(error)) continue;
      sum += error * error;
      count += 1.0;
    }
  }
  ASSERT_GT(count, 100.0);
  EXPECT_NEAR(std::sqrt(sum / count), 1.0, 0.15);
}

TEST(EntryErrors, OutsideEveryBandThereIsNothingToCompare) {
  SolvedProblem a1 = solved_problem("A1");
  a1.solution.bands.front().band_hz = Range{1.0, 2.0};
  for (const double error : tasks::entry_errors(*a1.plan, a1.solution.bands).rms_db) EXPECT_TRUE(std::isnan(error));
}

TEST(EntryErrors, ThinnedCoordinatesKeepTheirEnds) {
  Dofs dofs;
  for (std::size_t i = 1; i <= 10; ++i) dofs.push_back(frf::Dof::parse(std::to_string(i) + ":+Y"));
  const Dofs three = tasks::thinned(dofs, 3);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three.front(), dofs.front());
  EXPECT_EQ(three.back(), dofs.back());
  EXPECT_EQ(tasks::thinned(dofs, 10), dofs);
}

}  // namespace
}  // namespace jointid::ident
