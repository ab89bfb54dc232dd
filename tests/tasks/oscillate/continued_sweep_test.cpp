#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "tasks/oscillate/oscillate_scene.hpp"
#include "tasks/oscillate/run_oscillate.hpp"
#include "tests/require.hpp"

/// Sweeps that go on from the last state, and those of reduced models, against golden/seeds.json (seeds.md 13).
namespace jointid::tasks {
namespace {

using nlohmann::json;

std::filesystem::path seeds_file() {
  return std::filesystem::path(JOINTID_EXTERNAL_DATA).parent_path() / "golden" / "seeds.json";
}

json case_of(const std::string& name) {
  std::ifstream in(seeds_file());
  if (!in) return nullptr;
  const json all = json::parse(in);
  for (const json& each : all["cases"]) {
    if (each["name"] == name) return each;
  }
  return nullptr;
}

std::string belt(const std::string& start, double velocity) {
  return "[system]\nkind = \"belt_chain\"\nmasses = 3\nmass = 1.0\nstiffness = 1.0\ndamping = 0.1\nvelocity = " +
         std::to_string(velocity) + "\n[friction]\nkinetic = 0.3\nstatic = 0.5\ndecay = 2.0\nnormal = 3.0\n" + start +
         "[motion]\ntransient = 300.0\nlength = 100.0\nstep = 0.05\n";
}

OscillateResult result_of(const std::string& text) { return run_oscillate(parse_oscillate_scene(text, "scene.toml"), {}, {}); }

std::string range(double from, double to, const std::string& more) {
  return "[sweep]\nparameter = \"velocity\"\nrange = [" + std::to_string(from) + ", " + std::to_string(to) + "]\n" + more;
}

/// Rows of [V, range, break-aways, share of stick]; those of nearly steady sliding depend on the last digit of its growth.
void expect_rows(const std::vector<oscillation::SweepPoint>& found, const json& rows, int direction) {
  ASSERT_EQ(found.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double expected = rows[i][1];
    ASSERT_TRUE(found[i].range) << i;
    const oscillation::SweptRange& range = *found[i].range;
    EXPECT_NEAR(found[i].parameter, rows[i][0].get<double>(), 1e-12);
    EXPECT_EQ(found[i].direction, direction);
    if (rows[i][2] == 0) {
      EXPECT_NEAR(range.largest - range.smallest, expected, 0.02 * expected) << i;
      EXPECT_EQ(range.break_aways, 0u);
      continue;
    }
    EXPECT_NEAR(range.largest - range.smallest, expected, 1e-3 * expected) << i;
    EXPECT_NEAR(static_cast<double>(range.break_aways), rows[i][2].get<double>(), 1.0) << i;
    EXPECT_NEAR(range.stick_share, rows[i][3].get<double>(), 0.03) << i;
  }
}

TEST(ContinuedSweep, OfTheBeltHasTheGoldenHysteresis) {
  const json one = case_of("belt_hysteresis");
  if (one.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const std::string rest = "points = 23\ntransient = 300.0\nlength = 100.0\ncontinued = true\n";
  const OscillateResult up = result_of(belt("", 0.8) + range(0.8, 3.0, rest));
  expect_rows(up.sweep, one["expected"]["up"], 1);
  EXPECT_NEAR(*up.sliding_limit, one["expected"]["sliding_loses_stability_at"].get<double>(), 1e-11);
  const double force = 3.0 * (0.3 + 0.2 * std::exp(-6.0)) * 1.001;
  const json sliding = {force, 2.0 * force, 3.0 * force};
  const OscillateResult down = result_of(belt("[start]\ndisplacement = " + sliding.dump() + "\n", 3.0) + range(3.0, 0.8, rest));
  expect_rows(down.sweep, one["expected"]["down"], -1);
}

/// Up beyond the end of stick–slip and back: at 3 the way up sticks and slips, the way down slides.
TEST(ContinuedSweep, ThereAndBackShowsTheWindow) {
  const OscillateResult both = result_of(
      belt("", 2.0) + range(2.0, 4.6, "points = 27\ntransient = 300.0\nlength = 100.0\ncontinued = true\nback = true\n"));
  ASSERT_EQ(both.sweep.size(), 53u);
  const auto width = [&](std::size_t i) { return both.sweep[i].range->largest - both.sweep[i].range->smallest; };
  EXPECT_NEAR(both.sweep[10].parameter, 3.0, 1e-12);
  EXPECT_NEAR(both.sweep[42].parameter, 3.0, 1e-12);
  EXPECT_EQ(both.sweep[42].direction, -1);
  EXPECT_NEAR(width(10), 14.83, 0.01);
  EXPECT_LT(width(42), 0.01);
}

TEST(ContinuedSweep, OfReducedModelsHasTheGoldenPeriods) {
  const json one = case_of("reduced_sweep");
  if (one.is_null()) JOINTID_SKIP("no reference file " << seeds_file());
  const json& expected = one["expected"];
  const OscillateResult found =
      result_of(belt("", 1.2) + "[orbit]\nslips = 1\n" +
                range(0.8, 2.0, "points = 4\ntransient = 1500.0\nlength = 200.0\ncontinued = true\nreduced = true\n") +
                "[reduction]\nbases = [\"pod\", \"normal_modes\"]\norders = [1, 2]\nfrom = \"orbit\"\n");
  std::map<std::string, const std::vector<oscillation::SweepPoint>*> models = {{"full", &found.sweep}};
  for (const ReducedSweep& each : found.reduced_sweeps)
    models[(each.basis == BasisKind::pod ? "POM " : "normal ") + std::to_string(each.order)] = &each.points;
  for (const auto& point : expected["points"].items()) {
    const std::string velocity = point.key();
    for (const auto& [model, row] : point.value().items()) {
      const auto& points = *models.at(model);
      const auto at =
          std::ranges::find_if(points, [&](const auto& p) { return std::abs(p.parameter - std::stod(velocity)) < 1e-9; });
      ASSERT_NE(at, points.end());
      ASSERT_TRUE(at->range) << model << velocity;
      const double digits = model.starts_with("POM") ? 2e-3 : 1e-5;  // the modes are of other samples of the same period
      EXPECT_NEAR(at->range->period / static_cast<double>(at->range->slips), row[0].get<double>(), digits * row[0].get<double>())
          << model << " " << velocity;
      EXPECT_NEAR(at->range->largest, row[1].get<double>(), 2.0 * std::max(digits, 1e-4) * row[1].get<double>())
          << model << " " << velocity;
    }
  }
}

TEST(ContinuedSweep, RefusesWhatDoesNotFit) {
  for (const auto& [more, words] :
       {std::pair<std::string, std::string>{"back = true\n", "only a continued sweep"}, {"reduced = true\n", "no [reduction]"}}) {
    try {
      (void)parse_oscillate_scene(belt("", 1.0) + range(1.0, 2.0, "points = 3\nlength = 10.0\n" + more), "scene.toml");
      ADD_FAILURE() << more;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace jointid::tasks
