#include "cli/response/response_command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include "frf/hdf5/table_file.hpp"
#include "report/response/curve_rows.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/run_response.hpp"
#include "tests/tasks/response/response_sample.hpp"

namespace jointid::cli {
namespace {

using tasks::chain;
using tasks::further;
using tasks::parts_scene;
using tasks::replaced;
using tasks::rest;
using tasks::write_parts;
using testing::HasSubstr;

TEST(ResponseCommand, NoOutputReplacesAnInput) {
  const TestFolder folder;
  std::ofstream(folder / "scene.toml") << replaced(chain, "mass = [[1.0, 0.0, 0.0], [0.0, 1.2, 0.0], [0.0, 0.0, 0.9]]",
                                                   "mass = \"m.mtx\"")
                                       << rest;
  std::ofstream(folder / "m.mtx")
      << "%%MatrixMarket matrix coordinate real symmetric\n% masses\n3 3 3\n1 1 1.0\n2 2 1.2\n3 3 0.9\n";
  ResponseArguments arguments = {.scene = folder / "scene.toml", .json = (folder / "m.mtx").string(), .csv = {}};
  std::ostringstream out;
  EXPECT_THROW(execute(arguments, out), InputError);
  arguments.json = (folder / "scene.toml").string();
  EXPECT_THROW(execute(arguments, out), InputError);
  arguments.json.reset();
  EXPECT_EQ(execute(arguments, out), ExitCode::done);
}

TEST(ResponseCommand, WritesPageAndTables) {
  const TestFolder folder;
  std::ofstream(folder / "scene.toml") << chain + rest + further + "[transient]\nduration = 1.0\nstep = 0.01\n";
  ResponseArguments arguments;
  arguments.scene = folder / "scene.toml";
  arguments.report = (folder / "page.html").string();
  arguments.out = (folder / "response.h5").string();
  arguments.history = (folder / "history.h5").string();
  arguments.curves = (folder / "curves.h5").string();
  std::ostringstream out;
  EXPECT_EQ(execute(arguments, out), ExitCode::done);
  std::ifstream file(folder / "page.html");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const char* word :
       {"Response over frequency", "Harmonics", "Loops of the joints", "Curves", "Equivalent joints", "Motions from rest"}) {
    EXPECT_THAT(page, HasSubstr(word));
  }
  const frf::TableReader responses(folder / "response.h5"), history(folder / "history.h5");
  EXPECT_EQ(responses.rows(), 2u * 41u * 3u * 2u);
  EXPECT_EQ(responses.header().texts.at("dofs"), "1,3");
  EXPECT_EQ(history.rows(), 2u * 101u);
  const frf::TableReader curves(folder / "curves.h5");
  const tasks::ResponseResult run = tasks::run_response(tasks::parse_response_scene(chain + rest + further, "scene.toml"));
  EXPECT_EQ(curves.rows(), report::curve_rows(run).size());
  EXPECT_EQ(curves.header().texts.at("curves"), "peaks over force N;force N;k of 2–3");
  const std::string csv = report::curves_csv(run);
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), curves.rows() + 1);
  EXPECT_THAT(csv, HasSubstr("peaks over force N,peak,3,3,"));
  arguments.out = "-";
  EXPECT_THROW(execute(arguments, out), InputError);
  arguments.out.reset();
  arguments.compare = true;
  EXPECT_THROW(execute(arguments, out), InputError);
}

/// What the command answers, its JSON behind its text; or the line of its error.
struct Answer {
  ExitCode code = ExitCode::done;
  std::string text, error;
  std::size_t lines_with(const std::string& words) const {
    std::size_t found = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) found += line.find(words) == std::string::npos ? 0U : 1U;
    return found;
  }
};

Answer answer_to(const std::string& scene, const TestFolder& folder) {
  std::ofstream(folder / "scene.toml") << scene;
  ResponseArguments arguments{.scene = folder / "scene.toml"};
  std::ostringstream out;
  try {
    return {execute(arguments, out), out.str(), ""};
  } catch (const InputError& error) {
    return {ExitCode::usage, out.str(), error.what()};
  }
}

/// Harmonics and frequencies beyond the lines, DOFs that no file has, FRFs that feed energy, joints that leave no motion: one
/// line.
TEST(ResponseCommand, SaysInOneLineWhatTheFilesDoNotHold) {
  const TestFolder folder;
  write_parts(folder);
  const std::string good = parts_scene("values = [3.0]\n", "[1, 3]");
  const Answer beyond = answer_to(parts_scene("values = [7.0]\n", "[1, 3]"), folder);
  EXPECT_EQ(beyond.code, ExitCode::done);
  EXPECT_EQ(beyond.lines_with("harmonics beyond the lines of the files are dropped"), 1u) << beyond.text;
  const std::vector<std::array<std::string, 3>> wrong = {
      {"values = [3.0]", "values = [30.0]", "no line at 30"},
      {"values = [3.0]", "values = [3.01]", "no line at 3.01"},
      {"dof = \"1:+X\"", "dof = \"9:+X\"", "reference 9:+X: no file has it; did you mean "},
      {"dofs = [\"1:+X\", \"3:+X\"]", "dofs = [\"1:+X\", \"9:+X\"]", "response 9:+X: no file has it"},
      {"dofs = [\"2:+X\", \"3:+X\"]", "dofs = [\"2:+X\", \"9:+X\"]", "9:+X: no file has it"},
      {"parameters = [0.01, 150.0]\n", "", "the key 'parameters' is missing"},
  };
  for (const auto& [what, by, message] : wrong) {
    const Answer answer = answer_to(replaced(good, what, by), folder);
    EXPECT_THAT(answer.error, HasSubstr(message)) << by;
    EXPECT_EQ(answer.error.find('\n'), std::string::npos);
    EXPECT_EQ(answer.text, "");
  }
  const Answer rigid = answer_to(replaced(good, "[0.01, 150.0]", "[1e-14, 1e14]"), folder);
  EXPECT_EQ(rigid.lines_with("so stiff, or so loose, that its motion is rounding") + rigid.lines_with("did not converge at"), 1u)
      << rigid.text;
  EXPECT_EQ(rigid.text.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace jointid::cli
