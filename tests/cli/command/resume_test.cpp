// `solve` and `response` that were interrupted go on with --resume.
#include <gmock/gmock.h>

#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>

#include "input_folder.hpp"
#include "problems/problem.hpp"
#include "run_command.hpp"
#include "terminal.hpp"

namespace jointid::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Many frequencies, so that a signal comes within the level after that whose begin is awaited.
const std::string chain_scene = R"(
[structure]
mass = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.9]]
stiffness = [[500.0, -200.0, 0.0], [-200.0, 250.0, -50.0], [0.0, -50.0, 150.0]]
damping = [[0.5, -0.16, 0.0], [-0.16, 0.32, -0.04], [0.0, -0.04, 0.21]]
[[joints]]
dofs = [2, 3]
law = "ren"
parameters = { a = 0.004, b = 1.5, k = 150.0 }
[force]
dof = 1
amplitudes = [1.0, 2.0, 3.0]
[frequency]
range = [2.0, 4.0]
points = 2001
[response]
dofs = [1, 3]
harmonics = [1, 3, 5, 7, 9]
)";

/// Without how it was made and how long that took.
json result_of(const InputFolder& folder, const std::string& name) {
  json result = json::parse(folder.text(name));
  for (const char* key : {"provenance", "runtime_s"}) result.erase(key);
  return result;
}

/// Interrupts a run when its terminal shows `sign`; what it showed then. Where the run was faster, once more.
std::string interrupted(const InputFolder& folder, const std::vector<std::string>& command, const std::string& sign, int signal) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const Terminal terminal;
    Command run(folder.path(), command, {.out = -1, .err = terminal.descriptor()});
    terminal.until(sign);
    run.interrupt(signal);
    const Outcome outcome = run.wait();
    if (outcome.code == 130) return terminal.until("continues");
    EXPECT_EQ(outcome.code, 0);
  }
  return "never interrupted";
}

TEST(Resume, AResponseGoesOnFromItsFinishedLevels) {
  const InputFolder folder;
  folder.write("chain.toml", chain_scene);
  ASSERT_EQ(run_command(folder.path(), {"response", "chain.toml", "--json", "whole.json"}).code, 0);
  for (const bool from_start : {false, true}) {
    std::vector<std::string> command = {"response", "chain.toml", "--json", "x.json"};
    if (from_start) command.emplace_back("--resume");
    const std::string shown = interrupted(folder, command, "3 N: line ", from_start ? SIGTERM : SIGINT);
    EXPECT_THAT(shown, HasSubstr("interrupted; chain.response.partial keeps 2 of 3 force levels"));
    EXPECT_THAT(shown, HasSubstr("the same command with --resume continues"));
    const Outcome done = run_command(folder.path(), {"response", "chain.toml", "--json", "x.json", "--resume"});
    EXPECT_EQ(done.code, 0) << done.err;
    EXPECT_TRUE(result_of(folder, "x.json") == result_of(folder, "whole.json"));
    EXPECT_FALSE(std::filesystem::exists(folder.path("chain.response.partial")));
  }
}

/// The likelihood of rig1 in its scene's own file.
void write_likelihood(const InputFolder& folder) {
  problems::write(problems::make("rig1"), folder.path(), {});
  folder.replace("rig1.toml", "method = \"one\"", "method = \"likelihood\"");
}

void expect_same_minimum(const json& a, const json& b) {
  ASSERT_EQ(a.at("unknowns").size(), b.at("unknowns").size());
  EXPECT_EQ(a.at("status"), b.at("status"));
  for (std::size_t i = 0; i < a.at("unknowns").size(); ++i) {
    const json &one = a["unknowns"][i], &other = b["unknowns"][i];
    EXPECT_NEAR(one.at("value"), other.at("value"), 1e-2 * one.at("std_error").get<double>()) << one.at("name");
    EXPECT_NEAR(one.at("std_error").get<double>() / other.at("std_error").get<double>(), 1.0, 1e-3) << one.at("name");
  }
}

TEST(Resume, ASolutionGoesOnFromItsBestValues) {
  const InputFolder folder;
  write_likelihood(folder);
  ASSERT_EQ(run_command(folder.path(), {"solve", "rig1.toml", "--json", "whole.json"}).code, 0);
  const std::string shown = interrupted(folder, {"solve", "rig1.toml", "--json", "x.json"}, "iteration 4: line ", SIGTERM);
  EXPECT_THAT(shown, HasSubstr("rig1.solve.partial keeps them, the same command with --resume continues"));
  EXPECT_EQ(result_of(folder, "x.json").at("status"), "not_converged");
  const Outcome done = run_command(folder.path(), {"solve", "rig1.toml", "--json", "x.json", "--resume"});
  EXPECT_EQ(done.code, 0) << done.err;
  const json resumed = result_of(folder, "x.json"), whole = result_of(folder, "whole.json");
  expect_same_minimum(resumed, whole);
  EXPECT_LE(resumed.at("fit").at("iterations"), whole.at("fit").at("iterations"));  // true FRFs are fitted anew
  EXPECT_FALSE(std::filesystem::exists(folder.path("rig1.solve.partial")));
}

/// Its unknowns are all that its iteration remembers, so that steps are saved.
TEST(Resume, NewtonGoesOnWithFewerSteps) {
  const InputFolder folder;
  problems::write(problems::make("H4"), folder.path(), {});
  ASSERT_THAT(run_command(folder.path(), {"solve", "H4.toml", "--json", "whole.json"}).code, ::testing::AnyOf(0, 4));
  interrupted(folder, {"solve", "H4.toml", "--json", "x.json", "--resume"}, "step 5", SIGTERM);
  const Outcome done = run_command(folder.path(), {"solve", "H4.toml", "--json", "x.json", "--resume"});
  EXPECT_THAT(done.code, ::testing::AnyOf(0, 4)) << done.err;
  const json resumed = result_of(folder, "x.json"), whole = result_of(folder, "whole.json");
  EXPECT_LT(resumed.at("fit").at("iterations"), whole.at("fit").at("iterations"));
  for (std::size_t i = 0; i < whole.at("unknowns").size(); ++i) {
    const double value = whole["unknowns"][i].at("value");
    EXPECT_NEAR(resumed["unknowns"][i].at("value").get<double>() / value, 1.0, 1e-3) << whole["unknowns"][i].at("name");
  }
}

/// A state as a run leaves it; in no time at all a run keeps nothing.
void leave_state(const InputFolder& folder) {
  interrupted(folder, {"response", "chain.toml", "--json", "x.json"}, "2 N: line ", SIGTERM);
  ASSERT_TRUE(std::filesystem::exists(folder.path("chain.response.partial")));
}

TEST(Resume, AStateOfOtherInputsIsRefusedAndNamesThem) {
  const InputFolder folder;
  folder.write("chain.toml", chain_scene);
  leave_state(folder);
  const std::vector<std::string> command = {"response", "chain.toml", "--resume"};
  const std::string state = folder.text("chain.response.partial");
  folder.replace("chain.toml", "k = 150.0", "k = 151.0");
  const Outcome other = run_command(folder.path(), command);
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, HasSubstr("chain.response.partial: --resume: it belongs to another scene; repeat the run as it was, or remove the "
                                   "file to start anew"));
  EXPECT_EQ(folder.text("chain.response.partial"), state);
  folder.write("chain.toml", "# the same with a comment\n" + chain_scene);
  EXPECT_EQ(run_command(folder.path(), command).code, 0);
  write_likelihood(folder);
  interrupted(folder, {"solve", "rig1.toml", "--json", "x.json"}, "iteration 4: line ", SIGTERM);
  problems::write(problems::make("rig1"), folder.path(), {.seed = 2});
  folder.replace("rig1.toml", "method = \"one\"", "method = \"likelihood\"");
  const Outcome files = run_command(folder.path(), {"solve", "rig1.toml", "--resume"});
  EXPECT_EQ(files.code, 2);
  EXPECT_THAT(files.err, HasSubstr("another content of "));
  EXPECT_THAT(files.err, HasSubstr("rig1_assembly"));
}

TEST(Resume, ADamagedStateIsRefused) {
  const InputFolder folder;
  folder.write("chain.toml", chain_scene);
  leave_state(folder);
  const std::string state = folder.text("chain.response.partial");
  const auto code_of = [&](const std::string& text) {
    folder.write("chain.response.partial", text);
    return run_command(folder.path(), {"response", "chain.toml", "--resume"}).code;
  };
  for (const std::size_t bytes : {std::size_t{20}, std::size_t{200}, state.size() / 2, state.size() - 1})
    EXPECT_EQ(code_of(state.substr(0, bytes)), 3) << bytes;
  std::string bad = state;
  bad[state.size() / 2] ^= 1;
  EXPECT_EQ(code_of(bad), 3);
  EXPECT_EQ(code_of("# of somebody else\n"), 2) << "no file of jointid";
}

TEST(Resume, StopsBeforeSecondsAndKeepsWhatIsFinished) {
  const InputFolder folder;
  folder.write("chain.toml", chain_scene);
  const Outcome stopped = run_command(folder.path(), {"response", "chain.toml", "--stop-before", "1e-9"});
  EXPECT_EQ(stopped.code, 130);
  EXPECT_THAT(stopped.err, HasSubstr("interrupted"));
  EXPECT_EQ(run_command(folder.path(), {"response", "chain.toml", "--stop-before", "0"}).code, 2);
  EXPECT_EQ(run_command(folder.path(), {"solve", "A1.toml", "--stop-before", "-1"}).code, 2);
  EXPECT_EQ(run_command(folder.path(), {"response", "chain.toml", "--compare", "--resume"}).code, 2);
}

}  // namespace
}  // namespace jointid::cli
