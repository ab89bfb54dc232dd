#include "wrong_input.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "run_command.hpp"

namespace jointid::cli {
namespace {

using testing::EndsWith;
using testing::StartsWith;

/// All parts stand in the text, one behind the other.
void expect_in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    const std::size_t found = text.find(part, at);
    ASSERT_NE(found, std::string::npos) << "'" << part << "' is not in its place in:\n" << text;
    at = found + part.size();
  }
}

TEST_P(WrongInput, IsOneLineThatSaysWhatWhereAndWhatToDo) {
  const Wrong& wrong = GetParam();
  const InputFolder folder;
  if (wrong.spoil) wrong.spoil(folder);
  const auto before = folder.content();
  const Outcome outcome = run_command(folder.path(), wrong.command);
  RecordProperty("message", outcome.err);
  EXPECT_EQ(outcome.code, wrong.code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, StartsWith("jointid: error: "));
  EXPECT_THAT(outcome.err, EndsWith("\n"));
  EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
  expect_in_order(outcome.err, wrong.says);
  EXPECT_TRUE(folder.content() == before) << "a file was made, changed or removed";
}

}  // namespace
}  // namespace jointid::cli
