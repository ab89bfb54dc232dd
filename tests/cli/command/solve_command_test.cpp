// What `jointid solve` prints, whole.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

using Json = nlohmann::json;

/// The solution of the scene as JSON without its times, which differ from run to run, and its command line.
Json solution(const InputFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> arguments = {"solve", "A1.toml", "--json", "-"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_command(folder.path(), arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  Json json = Json::parse(outcome.out);
  json.erase("runtime_s");
  json.erase("provenance");
  return json;
}

TEST(SolveCommand, TheResultDoesNotDependOnTheThreads) {
  for (const std::string method : {"one", "likelihood"}) {
    const InputFolder folder;
    folder.replace("A1.toml", "method = \"one\"", "method = \"" + method + "\"");
    const Json alone = solution(folder, {"--threads", "1"});
    EXPECT_EQ(alone["used"]["method"], method);
    for (const std::string threads : {"0", "2", "3"})
      EXPECT_EQ(solution(folder, {"--threads", threads}), alone) << method << threads;
  }
}

TEST(SolveCommand, SaysWhichMethodItChoseAndWhy) {
  const InputFolder folder;
  EXPECT_FALSE(solution(folder, {})["used"].contains("chosen"));
  folder.replace("A1.toml", "method = \"one\"\n", "");
  EXPECT_THAT(solution(folder, {})["used"]["chosen"].get<std::string>(), StartsWith("method one: the scene names a weighting"));
  folder.replace("A1.toml", "weighting = \"WA\"", "method = \"auto\"");
  const Json chosen = solution(folder, {})["used"];
  EXPECT_EQ(chosen["method"], "likelihood");
  EXPECT_THAT(chosen["chosen"].get<std::string>(), HasSubstr("variances of the FRFs are known"));
}

}  // namespace
}  // namespace jointid::cli
