#include <gmock/gmock.h>

#include "base/error.hpp"
#include "cli/commands.hpp"
#include "cli/compare/compare_command.hpp"
#include "cli/convert/info_command.hpp"
#include "cli/problem/problem_command.hpp"
#include "cli/solve/solve_command.hpp"
#include "cli/stability/stability_command.hpp"
#include "cli/study/study_command.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

std::variant<ChosenCommand, Notice> parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "jointid");
  return parse_all(static_cast<int>(words.size()), words.data());
}

template <class T>
T command(std::vector<const char*> words) {
  return std::any_cast<T>(std::get<ChosenCommand>(parsed(std::move(words))).arguments);
}

Notice notice(std::vector<const char*> words) { return std::get<Notice>(parsed(std::move(words))); }

TEST(Arguments, SolveTakesASceneAndTargets) {
  const auto solve = command<SolveArguments>({"solve", "a.toml", "--json", "-"});
  EXPECT_EQ(solve.scene, "a.toml");
  EXPECT_EQ(solve.json, "-");
  EXPECT_FALSE(solve.csv.has_value());
}

TEST(Arguments, CompareTakesListsWithCommas) {
  const auto compare = command<CompareArguments>(
      {"compare", "a.toml", "--weightings", "none,WA", "--deltas", "0,0.05", "--equations", "nn nj;nn"});
  EXPECT_EQ(compare.scene, "a.toml");
  EXPECT_EQ(compare.weightings, (std::vector<std::string>{"none", "WA"}));
  EXPECT_EQ(compare.deltas, (std::vector<double>{0.0, 0.05}));
  EXPECT_EQ(compare.equations, "nn nj;nn");
  EXPECT_EQ(compare.trials, 200U);
}

TEST(Arguments, WholeNumbersMayHaveAnExponent) {
  const auto study = command<StudyArguments>({"study", "a.toml", "--trials", "1e3", "--seed", "18446744073709551615", "--threads", "2"});
  EXPECT_EQ(study.trials, 1000U);
  EXPECT_EQ(study.seed, 18446744073709551615U);
  EXPECT_EQ(study.threads, 2U);
  EXPECT_EQ(command<CompareArguments>({"compare", "a.toml", "--trials", "2.5e3"}).trials, 2500U);
  EXPECT_EQ(command<StabilityArguments>({"stability", "--scenes", "0"}).scenes, 0U);
}

TEST(Arguments, ProblemWriteHasTheDefaultsOfTheLibrary) {
  const auto write = command<ProblemWriteArguments>({"problem", "write", "A1", "dir"});
  EXPECT_EQ(write.name, "A1");
  EXPECT_EQ(write.options.format, problems::WriteOptions{}.format);
  EXPECT_EQ(write.options.seed, problems::WriteOptions{}.seed);
  EXPECT_FALSE(write.options.clean);
  EXPECT_TRUE(command<ProblemWriteArguments>({"problem", "write", "A1", "dir", "--clean"}).options.clean);
}

TEST(Arguments, AFileMayBeExplained) {
  const auto info = command<InfoArguments>({"info", "a.mat", "--quantity", "mobility", "--response", "4:+Y,4:-RZ", "--variable",
                                            "H", "--frequency-variable", "w", "--unit", "g/lbf"});
  EXPECT_EQ(info.open.frequency_variable, "w");
  EXPECT_EQ(info.open.quantity, frf::Quantity::mobility);
  ASSERT_EQ(info.open.response.size(), 2U);
  EXPECT_EQ(info.open.response[1].name(), "4:-RZ");
  EXPECT_EQ(info.open.variable, "H");
  EXPECT_EQ(info.open.unit, "g/lbf");
}

TEST(Arguments, HelpStandsAtEachLevelWithAnExample) {
  for (const auto& words : std::vector<std::vector<const char*>>{{"--help"},
                                                                 {"solve", "--help"},
                                                                 {"compare", "--help"},
                                                                 {"plan", "--help"},
                                                                 {"info", "--help"},
                                                                 {"convert", "--help"},
                                                                 {"problem", "--help"},
                                                                 {"problem", "list", "--help"},
                                                                 {"problem", "write", "--help"}}) {
    const Notice help = notice(words);
    EXPECT_EQ(help.code, ExitCode::done);
    EXPECT_THAT(help.text, HasSubstr("Example"));
    EXPECT_THAT(help.text, HasSubstr("\n  jointid "));
  }
}

TEST(Arguments, VersionSaysWhatTheBuildHas) {
  EXPECT_THAT(notice({"--version"}).text, HasSubstr("jointid 0.2"));
  EXPECT_THAT(notice({"--version"}).text, HasSubstr("MATLAB"));
}

TEST(Arguments, WrongUseIsOneLineThatLeadsToHelp) {
  const Notice misspelt = notice({"sovle", "a.toml"});
  EXPECT_EQ(misspelt.code, ExitCode::usage);
  EXPECT_THAT(misspelt.text, HasSubstr("did you mean 'solve'?"));
  EXPECT_EQ(misspelt.text.find('\n'), std::string::npos);

  EXPECT_THAT(notice({"solve"}).text, HasSubstr("`jointid solve --help`"));
  EXPECT_THAT(notice({"problem", "write", "A1"}).text, HasSubstr("`jointid problem write --help`"));
  EXPECT_EQ(notice({"problem", "write", "A1", "d", "--format", "xls"}).code, ExitCode::usage);
  EXPECT_EQ(notice({"problem", "write", "A1", "d", "--seed", "-1"}).code, ExitCode::usage);
  EXPECT_EQ(notice({"compare", "a.toml", "--reproduce", "6.3"}).code, ExitCode::usage);
  EXPECT_EQ(notice({"compare", "--reproduce", "6.3", "--deltas", "0.1"}).code, ExitCode::usage);
  EXPECT_EQ(notice({"compare", "a.toml", "--deltas", "x"}).code, ExitCode::usage);
  EXPECT_EQ(notice({}).code, ExitCode::usage);
}

TEST(Arguments, AWrongDofOrQuantityIsAnInputError) {
  EXPECT_THROW(parsed({"info", "a.mat", "--response", "4:+Q"}), InputError);
  EXPECT_THROW(parsed({"info", "a.mat", "--quantity", "volts"}), InputError);
}

}  // namespace
}  // namespace jointid::cli
