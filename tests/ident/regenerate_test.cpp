#include "tasks/regenerate.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

struct Solved {
  std::unique_ptr<Plan> plan;
  Solution solution;
};

/// A problem without noise, so that what is regenerated is what was measured.
Solved solved(const std::string& name, Range range_hz) {
  const problems::Problem problem = problems::make(name);
  Scene scene = problems::scene(problem);
  scene.frequency.range_hz = range_hz;
  Solved out{problems::plan(scene, {problem.substructures, problem.assembly}), {}};
  out.solution = solve(*out.plan);
  return out;
}

double largest_difference(const tasks::RegeneratedFrf& frf) {
  double largest = 0.0;
  for (std::size_t i = 0; i < frf.measured.size(); ++i) {
    largest = std::max(largest, std::abs(frf.predicted[i] - frf.measured[i]) / std::abs(frf.measured[i]));
  }
  return largest;
}

TEST(Regenerate, NoiseFreeDataComeBackAtAllLinesUsedOrNot) {
  Solved a1 = solved("A1", {400.0, 600.0});
  const auto entries = tasks::choose_entries(*a1.plan, 1000);
  const tasks::Regenerated out = tasks::regenerate(*a1.plan, a1.solution.bands, entries);
  EXPECT_GT(out.frequency_hz.size(), a1.plan->lines.size());
  ASSERT_EQ(out.frfs.size(), entries.size());
  for (const tasks::RegeneratedFrf& frf : out.frfs) {
    EXPECT_LE(largest_difference(frf), 1e-6) << frf.entry.response.name() << frf.entry.reference.name();
    EXPECT_LE(tasks::decibel_error(frf).value(), 1e-5);
  }
}

TEST(Regenerate, WhatTheEquationsDoNotReadIsReadForIt) {
  Solved b = solved("B", {100.0, 1000.0});
  ASSERT_FALSE(b.solution.fit.asm_frf_error.has_value());
  const tasks::Regenerated out = tasks::regenerate(*b.plan, b.solution.bands, tasks::choose_entries(*b.plan, 4));
  ASSERT_EQ(out.frfs.size(), 4U);
  for (const tasks::RegeneratedFrf& frf : out.frfs) EXPECT_LE(largest_difference(frf), 1e-6);
}

TEST(Regenerate, EntriesMayPointTheOtherWayThanTheJoint) {
  Solved a1 = solved("A1", {400.0, 600.0});
  tasks::FrfEntry entry = tasks::choose_entries(*a1.plan, 1).front();
  entry.reference = a1.plan->coordinates.joint.front();
  entry.reference.sign = -entry.reference.sign;
  const tasks::Regenerated out = tasks::regenerate(*a1.plan, a1.solution.bands, {entry});
  EXPECT_LE(largest_difference(out.frfs.front()), 1e-6);
}

TEST(Regenerate, LinesOutsideEveryBandAreNotPredicted) {
  Solved a1 = solved("A1", {400.0, 600.0});
  a1.solution.bands.front().band_hz = Range{400.0, 500.0};
  const tasks::Regenerated out = tasks::regenerate(*a1.plan, a1.solution.bands, tasks::choose_entries(*a1.plan, 1));
  for (std::size_t i = 0; i < out.frequency_hz.size(); ++i) {
    EXPECT_EQ(std::isfinite(out.frfs[0].predicted[i].real()), out.frequency_hz[i] < 500.0) << out.frequency_hz[i];
  }
}

TEST(Regenerate, EntriesAreSpreadAndDrivingPointsComeFirst) {
  const Solved a1 = solved("A1", {400.0, 600.0});
  const auto entries = tasks::choose_entries(*a1.plan, 10);
  ASSERT_EQ(entries.size(), 10U);
  EXPECT_EQ(entries.front().response, entries.front().reference);
  EXPECT_NE(entries.back().response, entries.back().reference);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    EXPECT_EQ(std::count(entries.begin(), entries.end(), entries[i]), 1);
  }
}

}  // namespace
}  // namespace jointid::ident
