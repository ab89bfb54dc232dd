#include "gui/scene/completion_place.hpp"

#include <gtest/gtest.h>

namespace jointid::gui {
namespace {

using Kind = CompletionPlace::Kind;

void expect_place(const std::string& before, Kind kind, const std::string& table, const std::string& key,
                  const std::string& prefix) {
  const CompletionPlace place = completion_place(before);
  EXPECT_EQ(place.kind, kind) << before;
  EXPECT_EQ(place.table, table) << before;
  EXPECT_EQ(place.key, key) << before;
  EXPECT_EQ(place.prefix, prefix) << before;
}

TEST(CompletionPlace, TellsTablesKeysAndValues) {
  expect_place("", Kind::key, "", "", "");
  expect_place("tit", Kind::key, "", "", "tit");
  expect_place("[da", Kind::header, "", "", "da");
  expect_place("[joint.sti", Kind::header, "", "", "joint.sti");
  expect_place("[data]\nass", Kind::key, "data", "", "ass");
  expect_place("[data]\n[joint.stiffness] # x\npat", Kind::key, "joint.stiffness", "", "pat");
  expect_place("[[joints]]\ndo", Kind::key, "joints", "", "do");
  expect_place("[identify]\nmethod = \"li", Kind::value, "identify", "method", "li");
  expect_place("[identify]\nequations = [\"nn\", \"", Kind::value, "identify", "equations", "");
}

TEST(CompletionPlace, AListOverSeveralLinesIsOneValue) {
  expect_place("[joint]\ndofs = [\n  \"1:+X\",\n  \"2", Kind::value, "joint", "dofs", "2");
  expect_place("[joint]\ndofs = [\n  \"1:+X\",\n]\nba", Kind::key, "joint", "", "ba");
  expect_place("[joint.stiffness]\nmatrix = [\n  [1, 2],\n", Kind::none, "joint.stiffness", "matrix", "");
}

TEST(CompletionPlace, NothingIsCompletedInCommentsAndNumbers) {
  EXPECT_EQ(completion_place("[data] # me").kind, Kind::none);
  EXPECT_EQ(completion_place("[frequency]\nstep = 1").kind, Kind::none);
}

TEST(LineOfKey, FindsKeysAndTables) {
  const std::string text = "title = \"dofs = 3\"\n[joint]\n# dofs = 1\ndofs = [\n\"1:+X\"]\n[joint.mass]\npattern = \"full\"\n";
  EXPECT_EQ(line_of_key(text, "joint", "dofs"), 4);
  EXPECT_EQ(line_of_key(text, "joint.mass", "pattern"), 7);
  EXPECT_EQ(line_of_key(text, "joint.mass", ""), 6);
  EXPECT_EQ(line_of_key(text, "joint", "bands"), 2);
  EXPECT_EQ(line_of_key(text, "truth", ""), 0);
}

TEST(TablesIn, AreInTheOrderOfTheTextWithTheirKeys) {
  const char* const text = R"(a = 1  # x = 2
# b = 2
[[t]]
m = [
  [1, 2],  # n = 3
  ["]", "o = 4"],
]
p = "q = 5"
[t.u]
"r s" = 6
[[t]]
[v] # w
z.y = 7)";
  std::vector<std::string> found;
  for (const TextTable& table : tables_in(text)) {
    found.push_back(table.path + ":");
    for (const std::string& key : table.keys) found.back() += " " + key;
  }
  EXPECT_EQ(found, (std::vector<std::string>{": a", "t#1: m p", "t#1.u: \"r s\"", "t#2:", "v: z.y"}));
  EXPECT_EQ(tables_in("").size(), 1u);
}

}  // namespace
}  // namespace jointid::gui
