#include "gui/scene/table_path.hpp"

#include <gmock/gmock.h>

#include "gui/scene/completion_place.hpp"
#include "gui/scene/joints_edit.hpp"
#include "gui/scene/several_edit.hpp"
#include "gui/scene/toml_edit.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::gui {
namespace {

using testing::Pair;

const std::string several = R"([data]
substructures = ["a", "b"]
assembly = ["c.uff"]
[data.files."c.uff"]
quantity = "mobility"

[[joints]]
name = "one"
dofs = ["1:+X", "2:+X"]
[joints.stiffness]
pattern = "full"

# of the second
[[joints]]
name = "two"
dofs = ["3:+X", "4:+X"]
[joints.mass]
pattern = "diagonal"
)";

TEST(TablePath, NamesWithDotsAreQuoted) {
  EXPECT_EQ(as_key("a-b_1"), "a-b_1");
  EXPECT_EQ(as_key("c.uff"), "\"c.uff\"");
  EXPECT_THAT(parted("data.files.\"c.uff\""), Pair("data.files", "\"c.uff\""));
  EXPECT_THAT(parted("data"), Pair("", "data"));
}

TEST(TablePath, HeadersAreThoseOfTheText) {
  EXPECT_EQ(header_of("joints#2"), "[[joints]]");
  EXPECT_EQ(header_of("joints#2.mass"), "[joints.mass]");
  EXPECT_EQ(header_of("data.files.\"a#1.uff\""), "[data.files.\"a#1.uff\"]");
}

TEST(TablePath, TablesOfSeveralAreCounted) {
  TablePath path;
  for (const char* line : {"[[joints]]", "[ joints . mass ] # x", "[[joints]]"}) EXPECT_TRUE(path.take(line)) << line;
  EXPECT_EQ(path.plain(), "joints");
  EXPECT_EQ(path.numbered(), "joints#2");
  for (const char* line : {"[1, 2],", "[\"1:+X\"] x", "dofs = []", "[open"}) EXPECT_FALSE(path.take(line)) << line;
  EXPECT_TRUE(path.take("[data.files.'c.uff']"));
  EXPECT_EQ(path.numbered(), "data.files.\"c.uff\"");
}

TEST(TablePath, ValuesOfOneOfSeveral) {
  EXPECT_EQ(value_of(several, "joints#2", "name"), "\"two\"");
  EXPECT_EQ(value_of(several, "joints#2.mass", "pattern"), "\"diagonal\"");
  EXPECT_EQ(value_of(several, "joints#1.mass", "pattern"), std::nullopt);
  EXPECT_EQ(value_of(several, "data.files.\"c.uff\"", "quantity"), "\"mobility\"");
  EXPECT_EQ(table_at(several, 11), "joints#1.stiffness");
  EXPECT_EQ(table_at(several, 5), "data.files.\"c.uff\"");
}

TEST(TablePath, ANewTableStandsBehindTheOthersOfItsJoint) {
  const std::string text = with_value(several, "joints#1.mass", "pattern", "\"full\"");
  std::string wanted = several;
  wanted.insert(wanted.find("\n# of the second"), "\n[joints.mass]\npattern = \"full\"\n");
  EXPECT_EQ(text, wanted);
  const std::string last = with_value(several, "joints#2.stiffness", "pattern", "\"full\"");
  EXPECT_EQ(last, several + "\n[joints.stiffness]\npattern = \"full\"\n");
  EXPECT_EQ(without_value(last, "joints#2.stiffness", "pattern"), several);
}

TEST(JointsEdit, AddsAndRemoves) {
  EXPECT_EQ(joints_in(several), 2);
  const std::string three = with_joint(several);
  EXPECT_EQ(joints_in(three), 3);
  EXPECT_EQ(value_of(three, "joints#3", "name"), "\"joint3\"");
  EXPECT_EQ(without_joint(three, 3), several);
  const auto scene = ident::parse_scene(without_joint(several, 1), "s.toml");
  ASSERT_EQ(scene.joints.size(), 1U);
  EXPECT_EQ(scene.joints.front().name, "two");
}

TEST(SeveralEdit, OneMoreStandsBehindTheOthersOrTheTableAbove) {
  const std::string text = "[data]\nassembly = [\"c\"]\n[data.files.c]\nmass = 1\n\n[joint]\ndofs = []\n";
  const std::string one = with_one_more(text, "data.gains", "gain = 1\n");
  EXPECT_EQ(one, "[data]\nassembly = [\"c\"]\n[data.files.c]\nmass = 1\n\n"
                 "[[data.gains]]\ngain = 1\n\n[joint]\ndofs = []\n");
  const std::string two = with_one_more(one, "data.gains", "gain = 2\n");
  EXPECT_EQ(several_in(two, "data.gains"), 2);
  EXPECT_EQ(value_of(two, one_of_several("data.gains", 2), "gain"), "2");
  EXPECT_EQ(without_one(two, "data.gains", 2), one);
  EXPECT_EQ(without_one(one, "data.gains", 1), text);
  EXPECT_EQ(without_one(text, "data.gains", 1), text);
  EXPECT_EQ(with_one_more("", "virtual_points", "name = \"VP1\"\n"), "\n[[virtual_points]]\nname = \"VP1\"\n");
}

/// The only joint becomes the first of several, and solves to the same with its name before its unknowns.
TEST(JointsEdit, TheOnlyJointBecomesTheFirst) {
  const std::string text = with_joint(
      "[data]\nsubstructures = [\"a\", \"b\"]\nassembly = [\"c\"]\n[joint] # x\ndofs = [\"1:+X\", \"2:+X\"]\n"
      "[joint.mass]\npattern = \"full\"");
  EXPECT_EQ(joints_in(text), 2);
  EXPECT_EQ(value_of(text, "joints#1", "dofs"), "[\"1:+X\", \"2:+X\"]");
  EXPECT_EQ(value_of(text, "joints#1.mass", "pattern"), "\"full\"");
  EXPECT_EQ(ident::parse_scene(with_value(text, "joints#2", "dofs", "[\"3:+X\", \"4:+X\"]"), "s.toml").joints.size(), 2U);
}

TEST(StringsIn, AreFoundInListsOfLists) {
  EXPECT_THAT(strings_in("[[\"a\", 'b'], # \"no\"\n \"c d\"]"), testing::ElementsAre("a", "b", "c d"));
}

}  // namespace
}  // namespace jointid::gui
