// Curves, stability, equivalent joints, transients, the comparison and the other outputs of `jointid response`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "problems/thesis/pulses.hpp"
#include "report/response/curve_rows.hpp"
#include "report/response/response_text.hpp"
#include "report/response/ways_text.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_result.hpp"
#include "tasks/response/response_scene.hpp"
#include "tasks/response/response_ways.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::tasks {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ResponseScene scene_of(const std::string& text) { return parse_response_scene(text, "scene.toml"); }

ResponseResult run_of(const ResponseScene& scene) { return run_response(scene); }

std::string at_one() { return replaced(rest, "range = [2.0, 4.0]\npoints = 41", "values = [3.0]"); }

TEST(ResponseFurther, FollowsCurvesOverForceAndParameter) {
  const ResponseScene scene = scene_of(chain + at_one() + further);
  const ResponseResult run = run_of(scene);
  ASSERT_EQ(run.curves.size(), 2u);
  EXPECT_TRUE(all_converged(run));
  // The curve over force passes the level that was solved for by itself: linear between its neighbours to the step's square.
  const CurveRun& force = run.curves[0];
  const double alone = std::abs(run.levels[1].points[0].response(0, 0));
  for (std::size_t i = 1; i < force.found.points.size(); ++i) {
    const double from = force.found.parameters[i - 1], to = force.found.parameters[i];
    if (from > 3.0 || to < 3.0) continue;
    const double share = (3.0 - from) / (to - from);
    const double size = (1.0 - share) * std::abs(force.found.points[i - 1].response(0, 0)) +
                        share * std::abs(force.found.points[i].response(0, 0));
    EXPECT_NEAR(size, alone, 2e-2 * alone);
  }
  EXPECT_EQ(run.curves[1].name, "k of 2–3");
  EXPECT_NEAR(std::abs(run.curves[1].found.points.front().response(0, 0)), std::abs(run.levels[0].points[0].response(0, 0)),
              1e-9);
  const auto out = json::parse(report::response_json(scene, run));
  EXPECT_EQ(out["curves"][0]["points"].size(), force.found.points.size());
  EXPECT_EQ(out["curves"][1]["joint"], "2–3");
  EXPECT_THAT(report::response_text(scene, run), HasSubstr("along k of 2–3, 1 N at 3 Hz"));
}

TEST(ResponseFurther, TellsEquivalentJointsAndModes) {
  const ResponseScene scene = scene_of(chain + at_one() + further);
  const ResponseResult run = run_of(scene);
  ASSERT_EQ(run.equivalents.size(), 3u);
  EXPECT_GT(run.equivalents[0].joints[0].stiffness, run.equivalents[2].joints[0].stiffness);  // it softens
  ASSERT_TRUE(run.equivalents[0].mode);
  EXPECT_GT(run.equivalents[0].mode->omega, run.equivalents[2].mode->omega);
  EXPECT_EQ(json::parse(report::response_json(scene, run))["equivalents"].size(), 3u);
}

TEST(ResponseFurther, TellsStabilityAndResidualForce) {
  const ResponseScene scene =
      scene_of(replaced(chain + at_one(), "harmonics = [1, 3, 5]", "harmonics = [1, 3, 5]\nstability = true"));
  const ResponseResult run = run_of(scene);
  for (const LevelResponse& level : run.levels) {
    ASSERT_EQ(level.stability.size(), 1u);
    EXPECT_TRUE(level.stability[0].known && level.stability[0].stable && !level.stability[0].another);
    EXPECT_LT(level.stability[0].difference, 0.05);
  }
  // 1 N moves the joint less than its slip, so it may keep a force.
  EXPECT_EQ(run.levels[0].stability[0].residual_force_free, (std::vector<std::string>{"2–3"}));
  EXPECT_NEAR(run.levels[0].stability[0].largest, 1.0, 1e-9);
  const std::string text = report::response_text(scene, run);
  EXPECT_THAT(text, HasSubstr("residual force free: 2–3"));
  EXPECT_THAT(text, HasSubstr("|μ|"));
  EXPECT_TRUE(json::parse(report::response_json(scene, run))["levels"][0]["points"][0]["stability"]["stable"]);
}

TEST(ResponseFurther, HasDampingAndLoopsOfPeaks) {
  const ResponseResult run = run_of(scene_of(chain + rest));
  for (const LevelResponse& level : run.levels) {
    ASSERT_TRUE(level.peak_mode);
    EXPECT_GT(level.peak_mode->ratio, 0.0);
    EXPECT_LT(level.peak_mode->ratio, 0.2);
    ASSERT_EQ(level.loops.size(), 1u);
    // The loop's area is the loss, by the trapezoidal rule.
    const response::JointLoop& loop = level.loops[0];
    double area = 0.0;
    const Eigen::Index n = loop.force.size();
    for (Eigen::Index i = 0; i < n; ++i) {
      area += 0.5 * (loop.force(i) + loop.force((i + 1) % n)) * (loop.displacement((i + 1) % n) - loop.displacement(i));
    }
    EXPECT_NEAR(area, level.peak->loss(0), 2e-3 * level.peak->loss(0));
  }
}

TEST(ResponseFurther, MarchesPulsesToTheirTruth) {
  const TestFolder folder;
  for (const problems::PulseProblem& pulse : problems::list_pulses()) {
    const ResponseScene scene = read_response_scene(problems::write(pulse, folder / pulse.name));
    for (std::size_t i = 0; i < problems::pulse_times.size(); ++i) {
      ResponseScene until = scene;
      until.transient->duration = until.transient->step = problems::pulse_times[i];
      const Eigen::MatrixXd x = run_of(until).transients.at(0).motion.x;
      for (std::size_t dof = 0; dof < 3; ++dof) EXPECT_NEAR(x(1, at(dof)), pulse.displacements[i][dof], 1e-10) << pulse.name;
    }
    const ResponseResult run = run_of(scene);
    ASSERT_EQ(run.transients.size(), 1u);
    EXPECT_TRUE(run.levels.empty());
    EXPECT_THAT(report::response_text(scene, run), HasSubstr("from rest"));
    EXPECT_EQ(json::parse(report::response_json(scene, run))["transients"][0]["times"].size(), 801u);
  }
}

TEST(ResponseFurther, MarchesRecordsFromFiles) {
  const TestFolder folder;
  std::ofstream record(folder / "push.csv");
  record << "time,F\n";
  for (int i = 0; i <= 40; ++i) record << 0.05 * i << "," << (i < 20 ? 2.0 * i : 0.0) << "\n";
  record.close();
  const std::string transient =
      "[transient]\nduration = 2.0\nstep = 0.01\nforces = [{ dof = 1, file = \"push.csv\", column = \"F\" }]\n";
  const auto read = [&](const std::string& section) {
    return parse_response_scene(chain + at_one() + section, folder / "scene.toml");
  };
  const Eigen::MatrixXd exact = run_of(read(transient)).transients.at(0).motion.x;
  for (const char* method : {"one", "two"}) {
    const std::string steps =
        replaced(transient, "step = 0.01\n", std::string("step = 0.01\nmethod = \"") + method + "\"\ndelta = 1e-3\n");
    const Eigen::MatrixXd other = run_of(read(steps)).transients.at(0).motion.x;
    EXPECT_LT((other - exact).cwiseAbs().maxCoeff(), 1e-2 * exact.cwiseAbs().maxCoeff()) << method;
  }
  const std::string twice = replaced(transient, "column = \"F\" }", "column = \"F\", factor = 2.0 }");
  EXPECT_GT(run_of(read(twice)).transients.at(0).motion.x.cwiseAbs().maxCoeff(), exact.cwiseAbs().maxCoeff());
  EXPECT_THROW(run_of(read(replaced(transient, "\"F\"", "\"G\""))), InputError);
  EXPECT_THROW(run_of(read(replaced(transient, "column = \"F\"", "column = \"F\", unit = \"m\""))), InputError);
  EXPECT_THROW(run_of(read(replaced(transient, "push.csv", "absent.csv"))), InputError);
}

TEST(ResponseFurther, SaysInOneLineWhatIsWrong) {
  const std::string good =
      chain + at_one() + further + "[transient]\nduration = 1.0\nstep = 0.1\nmethod = \"one\"\ndelta = 0.01\n";
  const std::vector<std::array<std::string, 3>> wrong = {
      {"along = \"force\"", "along = \"b2\"", "b2"},
      {"along = \"k\"\njoint = 1", "along = \"k\"\njoint = 2", "2 is not a whole number from 1 to 1"},
      {"range = [0.5, 8.0]", "range = [0.0, 8.0]", "forces are above 0"},
      {"range = [0.5, 8.0]", "range = [0.5, 0.5]", "both ends are 0.5"},
      {"range = [150.0, 60.0]", "range = [150.0, -60.0]", "k"},
      {"mode = 2", "mode = 4", "4 is not a whole number from 1 to 3"},
      {"delta = 0.01", "delta = 0.03", "not a whole part of step"},
      {"step = 0.1", "step = 0.3", "not a whole part of the duration"},
      {"method = \"one\"\n", "", "event-exact marching chooses its steps"},
      {"duration = 1.0", "duration = 1e9", "more than a million steps"},
  };
  EXPECT_EQ(error_of(good), "none");
  for (const auto& [what, by, message] : wrong) {
    const std::string found = error_of(replaced(good, what, by));
    EXPECT_THAT(found, HasSubstr(message)) << what << " → " << by;
    EXPECT_EQ(found.find('\n'), std::string::npos);
  }
}

TEST(ResponseFurther, TransientsKnowCubicSprings) {
  const std::string spring = replaced(chain + at_one(), "k = 150.0 }", "k = 150.0 }\ncubic = 1e3");
  const ResponseResult run = run_of(scene_of(spring + "[transient]\nduration = 1.0\nstep = 0.1\n"));
  EXPECT_EQ(run.marched, (std::vector<std::string>{"2–3", "2–3 cubic"}));
  EXPECT_THAT(report::history_csv(run), HasSubstr("q(2–3 cubic) [m]"));
  const response::Transient& motion = run.transients.at(0).motion;
  EXPECT_LT((motion.f.col(1) - 1e3 * motion.q.col(1).array().cube().matrix()).cwiseAbs().maxCoeff(),
            1e-9 * motion.f.col(1).cwiseAbs().maxCoeff());
}

/// On all three modes the motion is that of the coordinates; on one and the deflections nearly.
TEST(ResponseFurther, MarchesOnModes) {
  const std::string all = replaced(chain + at_one(), "[1, 3, 5]", "[1, 3, 5]\nstability = true") +
                          "[transient]\nduration = 1.0\nstep = 0.05\npulses = [{ dof = 1, amplitude = 5.0, length = 0.3 }]\n";
  const ResponseResult full = run_of(scene_of(all));
  const auto on = [&](const std::string& modes) {
    return run_of(scene_of(replaced(all, "[structure]\n", "[structure]\nmodes = " + modes + "\n")));
  };
  const auto difference = [&](const ResponseResult& run) {
    const Eigen::MatrixXd& exact = full.transients.at(0).motion.x;
    return (run.transients.at(0).motion.x - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
  };
  const ResponseResult three = on("3"), one = on("1");
  EXPECT_LT(difference(three), 1e-10);
  EXPECT_NEAR(three.levels[1].stability[0].largest, full.levels[1].stability[0].largest, 1e-9);
  EXPECT_LT(difference(one), 0.2);
  EXPECT_THAT(error_of(replaced(all, "[structure]\n", "[structure]\nmodes = 4\n")), HasSubstr("from 1 to 3"));
}

TEST(ResponseFurther, ComparesAllWays) {
  const ResponseScene scene = scene_of(replaced(chain + at_one(), "amplitudes = [1.0, 3.0]", "amplitudes = [8.0]"));
  const auto runs = compare_responses(scene);
  ASSERT_EQ(runs.size(), 1u);
  EXPECT_TRUE(all_known(runs));
  ASSERT_EQ(runs[0].ways.size(), 11u);
  EXPECT_LT(runs[0].ways[4].of_motion, runs[0].ways[1].of_motion);  // more harmonics
  EXPECT_THAT(report::ways_text(scene, runs), HasSubstr("Algorithm One, T/1000"));
  EXPECT_EQ(json::parse(report::ways_json(scene, runs))["cases"][0]["ways"].size(), 11u);
  EXPECT_THAT(report::ways_csv(runs), HasSubstr("harmonics to 9"));
  EXPECT_THROW(compare_responses(scene_of(chain + rest)), InputError);  // a range has no case
}

}  // namespace
}  // namespace jointid::tasks
