#include "laws/data/level_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "base/error.hpp"
#include "ident/plan/data_source.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The states are those that were simulated: a file of two harmonics, forces with phases.
TEST(LevelStates, AreThoseOfTheFiles) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const auto exact = problems::measure(problem);
  const LevelStates data = read_level_states(read_law_scene(problems::write(problem, folder, {.clean = true})));
  ASSERT_EQ(data.states.size(), problem.levels.size() * problem.frequency_hz.size());
  const response::MeasuredState& state = data.states[13];  // second line of the second level
  EXPECT_EQ(data.level[13], 1u);
  EXPECT_NEAR(state.omega, angular(problem.frequency_hz[1]), 1e-9);
  EXPECT_EQ(state.harmonics, (std::vector<int>{1, 3}));
  EXPECT_EQ(state.force.harmonics, (std::vector<int>{1, 3}));
  EXPECT_NEAR(std::abs(state.force.amplitudes(0, 0)), problem.levels[1], 1e-12);
  EXPECT_EQ(state.response(0, 0), exact.responses[1].values[1]);
  EXPECT_NEAR(state.deviation(0, 0), 0.01 * std::abs(state.response(0, 0)) / std::sqrt(2.0), 1e-12 * state.deviation(0, 0));
}

TEST(LevelStates, VariancesOfFilesCount) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const LevelStates data = read_level_states(read_law_scene(problems::write(problem, folder, {})));
  EXPECT_TRUE(data.structure->knows_errors());
  EXPECT_TRUE(data.notes.empty());
  EXPECT_NEAR(data.states[0].deviation(0, 0) / std::abs(data.states[0].response(0, 0)), 0.01 / std::sqrt(2.0), 1e-6);
}

/// Two harmonics in one file: it is opened once, parsed once, and asked for its DOFs besides.
TEST(LevelStates, OpenEveryFileOnce) {
  const TestFolder folder;
  const auto problem = problems::make_law_problem("sdof-iwan");
  const LawScene scene = read_law_scene(problems::write(problem, folder, {.clean = true}));
  std::map<std::filesystem::path, int> opened;
  read_level_states(scene, PhasorFiles([&](const std::vector<ident::DataFile>& files) {
                      for (const ident::DataFile& file : files) ++opened[file.path];
                      return ident::open_all(files);
                    }));
  EXPECT_EQ(opened.size(), 2 * problem.levels.size());
  for (const auto& [file, count] : opened) EXPECT_EQ(count, 1) << file;
}

/// The phasors of all harmonics are read in one go.
TEST(LevelStates, ReadEveryFileOnce) {
  const TestFolder folder;
  const LawScene scene = read_law_scene(problems::write(problems::make_law_problem("sdof-iwan"), folder, {.clean = true}));
  PhasorFiles files;
  const ForceLevel& level = scene.levels.front();
  const auto first = files.read(level.harmonics[0].responses, files.dofs(level.harmonics[0].responses));
  EXPECT_EQ(first, files.read(level.harmonics[1].responses, files.dofs(level.harmonics[1].responses)));
}

TEST(LevelStates, SayWhatIsNotThere) {
  const TestFolder folder;
  const auto path = problems::write(problems::make_law_problem("sdof-iwan"), folder, {.clean = true});
  const std::string text = text_of(path);
  const auto error_with = [&](const std::string& what, const std::string& by) -> std::string {
    std::string changed = text;
    const std::size_t place = changed.find(what);
    EXPECT_NE(place, std::string::npos) << what;
    changed.replace(place, what.size(), by);
    try {
      read_level_states(parse_law_scene(changed, path));
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_THAT(error_with("[errors]\nrelative = 0.01", ""), HasSubstr("nobody says how exact they are"));
  EXPECT_THAT(error_with("[80.0, 135.0]", "[1.0, 2.0]"), HasSubstr("no line of any level can be used"));
  EXPECT_THAT(error_with("dofs = [\"1:+Y\"]\nlaw", "dofs = [\"7:+Y\"]\nlaw"), HasSubstr("7:+Y"));
  EXPECT_THAT(error_with("level_2.h5", "level_9.h5"), HasSubstr("level_9.h5"));
}

}  // namespace
}  // namespace jointid::laws
