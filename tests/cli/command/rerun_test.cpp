// How results say that they were made, and `rerun`, which makes them again.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input_folder.hpp"
#include "run_command.hpp"
#include "tests/test_folder.hpp"

namespace jointid::cli {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

/// SHA-256 by the program of coreutils.
std::string sha256sum(const std::filesystem::path& file) {
  const std::filesystem::path sum = file.string() + ".sum";
  EXPECT_EQ(std::system(("sha256sum '" + file.string() + "' > '" + sum.string() + "'").c_str()), 0);
  std::string word;
  std::ifstream(sum) >> word;
  std::filesystem::remove(sum);
  return word;
}

json solved(const InputFolder& folder) {
  const Outcome done = run_command(folder.path(), {"solve", "A1.toml", "--json", "a1.json", "--report", "a1.html"});
  EXPECT_EQ(done.code, 0) << done.err;
  return json::parse(folder.text("a1.json"));
}

TEST(Provenance, NamesCommandFolderVersionCommitAndEveryInputWithItsSum) {
  const InputFolder folder;
  const json told = solved(folder).at("provenance");
  EXPECT_EQ(told.at("command"), json({"jointid", "solve", "A1.toml", "--json", "a1.json", "--report", "a1.html"}));
  EXPECT_TRUE(std::filesystem::equivalent(told.at("folder").get<std::string>(), folder.path()));
  EXPECT_THAT(told.at("version").get<std::string>(), MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(told.at("commit").get<std::string>(), MatchesRegex("unknown|[0-9a-f]+(-dirty)?"));
  std::vector<std::string> files;
  for (const json& input : told.at("inputs")) {
    files.push_back(std::filesystem::path(input.at("file").get<std::string>()).filename());
    EXPECT_EQ(input.at("bytes"), std::filesystem::file_size(folder.path(files.back())));
    EXPECT_EQ(input.at("sha256"), sha256sum(folder.path(files.back())));
  }
  EXPECT_THAT(files, ::testing::UnorderedElementsAre("A1.toml", "A1_assembly.h5", "A1_substructure_1.h5", "A1_substructure_2.h5"));
  EXPECT_THAT(told.at("libraries").dump(), HasSubstr("libhdf5"));
  EXPECT_THAT(folder.text("a1.html"), HasSubstr("How this page was made"));
  EXPECT_THAT(folder.text("a1.html"), HasSubstr(sha256sum(folder.path("A1.toml"))));
}

TEST(Provenance, TheSameRunGivesTheSameBytes) {
  const InputFolder folder;
  const auto without_times = [&] {
    json found = solved(folder);
    found.erase("runtime_s");
    return found.dump();
  };
  EXPECT_EQ(without_times(), without_times());
}

TEST(Rerun, FindsTheSameInputsAndAnswers) {
  const InputFolder folder;
  solved(folder);
  const std::string before = folder.text("a1.html");
  const Outcome again = run_command(folder.path(), {"rerun", "a1.json"});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("A1_assembly.h5"));
  EXPECT_THAT(again.out, Not(HasSubstr("changed")));
  EXPECT_THAT(again.out, HasSubstr("the same to the last bit"));
  EXPECT_EQ(folder.text("a1.html"), before) << "a repetition writes nothing beside";
}

/// Commands of several kinds, with files that they would write by themselves.
TEST(Rerun, RepeatsAnyCommandThatWritesJson) {
  const std::vector<std::vector<std::string>> commands = {
      {"check", "A1.toml"}, {"plan", "A1.toml"}, {"study", "A1.toml", "--trials", "4", "--out", "s.h5"}, {"compare", "A1.toml", "--trials", "2"},
      {"modalfit", "A1_assembly.h5"}, {"correlate", "A1_assembly.h5", "A1_assembly.h5"}};
  for (std::vector<std::string> command : commands) {
    const InputFolder folder;
    command.insert(command.end(), {"--json", "x.json"});
    const Outcome first = run_command(folder.path(), command);
    ASSERT_THAT(first.code, ::testing::AnyOf(0, 4)) << command[0] << first.err;
    const Outcome again = run_command(folder.path(), {"rerun", "x.json", "--json", "-"});
    EXPECT_EQ(again.code, 0) << command[0] << again.err << again.out;
    const json found = json::parse(again.out);
    EXPECT_EQ(found.at("answers").at("same"), true) << command[0];
    for (const json& input : found.at("inputs")) EXPECT_EQ(input.at("state"), "same") << input.dump();
  }
}

TEST(Rerun, TellsAChangedInputAndByHowMuchAnswersDiffer) {
  const InputFolder folder;
  solved(folder);
  folder.replace("A1.toml", "weighting = \"WA\"", "weighting = \"none\"");
  const Outcome again = run_command(folder.path(), {"rerun", "a1.json", "--json", "-"});
  EXPECT_EQ(again.code, 4) << again.err;
  const json found = json::parse(again.out);
  EXPECT_EQ(found.at("inputs")[0].at("state"), "changed");
  EXPECT_EQ(found.at("inputs")[1].at("state"), "same");
  EXPECT_EQ(found.at("answers").at("same"), false);
  EXPECT_GT(found.at("answers").at("different"), 0);
}

TEST(Rerun, InputsMayHaveMoved) {
  const InputFolder folder;
  solved(folder);
  const std::filesystem::path moved = folder.path("moved");
  std::filesystem::create_directory(moved);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    if (entry.is_regular_file() && entry.path().filename() != "a1.json") std::filesystem::rename(entry.path(), moved / entry.path().filename());
  }
  const Outcome lost = run_command(folder.path(), {"rerun", "a1.json"});
  EXPECT_EQ(lost.code, 3);
  EXPECT_THAT(lost.err, HasSubstr("an input of a1.json is not there; give its folder by --folder"));
  const Outcome found = run_command(folder.path(), {"rerun", "a1.json", "--folder", "moved"});
  EXPECT_EQ(found.code, 0) << found.err << found.out;
}

/// Errors of what is solved exactly are what rounding leaves: no digit of them is the same elsewhere.
bool is_rounding(const json& answers) {
  const auto size = [&](const char* key) { return std::abs(std::stod(answers.at(key).get<std::string>())); };
  return answers.at("at").get<std::string>().ends_with("error_of_energy") && std::max(size("before"), size("after")) < 1e-14;
}

constexpr double to_the_last_digits = 1e-6;  // errors of exact fits in dB: 1e-8 between compilers

/// Ten results of version 0.2.0 (commit 684aa36c), of as many commands and methods. Compilers and processors may differ in the last digits.
TEST(Rerun, FindsResultsOfAnOlderCommitTheSame) {
  const TestFolder folder;
  const std::filesystem::path kept = JOINTID_MADE_BEFORE;
  std::filesystem::copy(kept, folder / "kept");
  std::size_t results = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kept)) {
    if (entry.path().extension() != ".json") continue;
    ++results;
    const std::string name = entry.path().filename();
    const Outcome again = run_command(folder / "kept", {"rerun", name, "--folder", ".", "--json", "-"});
    ASSERT_THAT(again.code, ::testing::AnyOf(0, 4)) << name << again.err;
    const json found = json::parse(again.out);
    for (const json& input : found.at("inputs")) EXPECT_EQ(input.at("state"), "same") << name << input.dump();
    const json& answers = found.at("answers");
    EXPECT_GT(answers.at("values"), 50U) << name;
    EXPECT_TRUE(answers.value("largest_difference", 0.0) < to_the_last_digits || is_rounding(answers)) << name << answers.dump();
  }
  EXPECT_EQ(results, 10U);
}

TEST(Rerun, RefusesWhatDoesNotSayHowItWasMade) {
  const InputFolder folder;
  folder.write("old.json", "{\"status\": \"ok\"}\n");
  folder.write("torn.json", "{\"status\": ");
  folder.write("list.json", "[1, 2]\n");
  const Outcome old = run_command(folder.path(), {"rerun", "old.json"});
  EXPECT_EQ(old.code, 3);
  EXPECT_THAT(old.err, HasSubstr("old.json: provenance: does not state how the result was made; make the result again with --json"));
  for (const char* file : {"torn.json", "list.json", "not-there.json"}) EXPECT_EQ(run_command(folder.path(), {"rerun", file}).code, 3) << file;
}

}  // namespace
}  // namespace jointid::cli
