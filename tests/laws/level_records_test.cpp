#include "laws/data/level_records.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "base/error.hpp"
#include "base/random.hpp"
#include "frf/file/write.hpp"
#include "friction/law/laws.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "response/time/exact_march.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

constexpr double stiffness = 4e5, slip = 2.5e-5;
const std::vector<double> lines_hz = {100.0, 115.0, 125.0};

response::MatrixStructure mass() {
  const auto one = [](double x) { return Eigen::MatrixXd::Constant(1, 1, x); };
  return {one(1.0), one(40.0), one(2e5)};
}

std::shared_ptr<const friction::Element> law() {
  return friction::make_element("bilinear", std::vector<double>{slip, stiffness});
}

/// FRFs of the mass alone at 1, 3, 5 … times the lines.
void write_part(const std::filesystem::path& path) {
  frf::FrfSet set;
  for (const double hz : lines_hz) {
    for (int n = 1; n <= 15; n += 2) set.header.frequency_hz.push_back(n * hz);
  }
  std::ranges::sort(set.header.frequency_hz);
  const frf::Dof dof = frf::Dof::parse("1:+Y");
  set.header.response = set.header.reference = {dof};
  for (const double hz : set.header.frequency_hz) {
    const double omega = angular(hz);
    set.values.push_back(1.0 / Complex(2e5 - omega * omega, 40.0 * omega));
  }
  frf::write(set, path);
}

/// What instruments record of the assembly, marched from rest: force and displacement or velocity, columns of a text file.
void write_record(const std::filesystem::path& path, double hz, double newton, bool velocity, double noise) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  response::ExactMarch march(
      {mass(), one, {law()}},
      response::ForceHistory::periodic(angular(hz), {1}, Eigen::MatrixXcd::Constant(1, 1, std::polar(newton, 0.8))));
  constexpr double rate = 8192.0, seconds = 1.2;
  std::ofstream out(path);
  out << "time [s],force,motion\n";
  std::vector<double> force, motion;
  double largest = 0.0;
  for (std::size_t i = 0; static_cast<double>(i) < rate * seconds; ++i) {
    const double time = static_cast<double>(i) / rate;
    ASSERT_TRUE(march.march(time));
    force.push_back(newton * std::cos(angular(hz) * time + 0.8));
    motion.push_back(velocity ? march.motion().v(0) : march.motion().x(0));
    largest = std::max(largest, std::abs(motion.back()));
  }
  for (std::size_t i = 0; i < force.size(); ++i) {
    const auto [a, b] = normal_numbers({.seed = 7, .trial = static_cast<std::uint64_t>(10.0 * hz + newton)}, i);
    out << fmt::format("{:.10g},{:.12g},{:.12g}\n", static_cast<double>(i) / rate, force[i] + noise * newton * a,
                       motion[i] + noise * largest * b);
  }
}

std::string level_text(const std::string& name, const std::vector<std::string>& files, bool velocity) {
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "\"" : ", \"") + file + "\"";
  return fmt::format(
      "[[data.levels]]\nname = \"{}\"\nrecords = [{}]\nchannels = [\"force=1:+Y N\", \"motion=1:+Y {}\"]\n"
      "force_dofs = [\"1:+Y\"]\nharmonics = [1, 3]\nsettle = 0.4\n",
      name, list, velocity ? "m/s" : "m");
}

std::string scene_text(const std::string& levels) {
  return "[data]\nparts = [\"part.h5\"]\n" + levels +
         "[[joint.friction]]\nname = \"slot\"\ndofs = [\"1:+Y\"]\nlaw = \"bilinear\"\n";
}

/// Two levels in time, of displacement and of velocity.
class Recorded : public testing::Test {
 protected:
  void record(double noise) {
    write_part(folder_ / "part.h5");
    std::string levels;
    for (const double newton : {8.0, 25.0}) {
      std::vector<std::string> files;
      for (const double hz : lines_hz) {
        files.push_back(fmt::format("r{}_{}.csv", newton, hz));
        write_record(folder_ / files.back(), hz, newton, newton > 10.0, noise);
      }
      levels += level_text(fmt::format("{} N", newton), files, newton > 10.0);
    }
    text_ = scene_text(levels);
  }

  LawScene scene() const { return parse_law_scene(text_, folder_ / "scene.toml"); }

  TestFolder folder_;
  std::string text_;
};

/// Another way to the phasors: harmonic balance with 41 harmonics of the same structure and law.
TEST_F(Recorded, PhasorsAreThoseOfHarmonicBalance) {
  record(0.0);
  LawScene read = scene();
  read.errors = PhasorErrors{.relative = 1e-3};
  const LevelStates data = read_level_states(read);
  ASSERT_EQ(data.states.size(), 6u);
  const auto structure = std::make_shared<response::MatrixReceptance>(mass(), Eigen::MatrixXd::Ones(1, 1),
                                                                      Eigen::MatrixXd::Ones(1, 1), Eigen::MatrixXd::Ones(1, 1));
  std::vector<int> odd;
  for (int n = 1; n <= 41; n += 2) odd.push_back(n);
  for (const response::MeasuredState& state : data.states) {
    const Complex force = state.force.amplitudes(0, 0);
    const response::HarmonicBalance balance(structure, {{.name = "slot", .friction = law()}}, response::Excitation::single(force),
                                            {.fixed = odd});
    const auto solved = balance.solve(state.omega);
    ASSERT_TRUE(solved.converged);
    const Complex exact = solved.response(0, 0), third = solved.response(1, 0);
    EXPECT_LT(std::abs(state.response(0, 0) - exact), 2e-5 * std::abs(exact)) << hertz(state.omega);
    EXPECT_LT(std::abs(state.response(1, 0) - third), 2e-4 * std::abs(exact)) << hertz(state.omega);
  }
}

TEST_F(Recorded, TellTheLaw) {
  record(0.02);
  const LawIdentification found = identify_laws(scene());
  EXPECT_TRUE(is_usable(found.status)) << found.message;
  const response::FittedJoint& joint = found.fit().joints[0];
  EXPECT_LT(std::abs(joint.stiffness.value - stiffness), 4.0 * *joint.stiffness.std_error);
  EXPECT_LT(std::abs(joint.limit.value - stiffness * slip), 4.0 * *joint.limit.std_error);
  EXPECT_LT(*joint.limit.std_error, 0.01 * stiffness * slip);
  EXPECT_TRUE(found.data.states[0].knows_force_errors());
}

/// The sign of a channel's DOF is that of its numbers.
TEST_F(Recorded, MistakesAreTold) {
  record(0.0);
  const auto error_with = [&](const std::string& what, const std::string& by) -> std::string {
    std::string changed = text_;
    const std::size_t place = changed.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    changed.replace(place, what.size(), by);
    try {
      LawScene read = parse_law_scene(changed, folder_ / "scene.toml");
      read.errors = PhasorErrors{.relative = 1e-3};
      const LevelStates data = read_level_states(read);
      std::string notes;
      for (const std::string& note : data.notes) notes += note + "; ";
      return notes;
    } catch (const InputError& error) {
      return error.what();
    }
  };
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4"), testing::Not(HasSubstr("left out")));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 1.19"), HasSubstr("upward zero crossings"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\nlines = [100.0]"), HasSubstr("1 lines for 3 records"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\nlines = [100.0, 110.0, 125.0]"), HasSubstr("not 110 Hz"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\nsweep = true"), HasSubstr("does not sweep"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\nperiods = 20"), HasSubstr("one window"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\nrate = 8000.0"), HasSubstr("states 8192 samples per second"));
  EXPECT_THAT(error_with("settle = 0.4", "settle = 0.4\namplitude = 8.0"), HasSubstr("there are records, too"));
  EXPECT_THAT(error_with("force=1:+Y N", "force=2:+Y N"), HasSubstr("no channel is a force there"));
  EXPECT_THAT(error_with("force=1:+Y N", "force=1:+Y V"), HasSubstr("no unit of a force"));
  EXPECT_THAT(error_with("force=1:+Y N", "power=1:+Y N"), HasSubstr("power"));
  EXPECT_THAT(error_with("r8_100.csv", "r8_101.csv"), HasSubstr("r8_101.csv"));
  EXPECT_THAT(error_with("records = [\"r8_100.csv\", \"r8_115.csv\", \"r8_125.csv\"]\n", "amplitude = 8.0\n"),
              HasSubstr("there are no records"));
}

}  // namespace
}  // namespace jointid::laws
