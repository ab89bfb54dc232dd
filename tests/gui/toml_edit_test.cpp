#include "gui/scene/toml_edit.hpp"

#include <gmock/gmock.h>

namespace jointid::gui {
namespace {

using testing::ElementsAre;
using testing::Optional;

const char* const text = R"(# what this is
title = "one"
joint.dofs = ["1:+X"]
[a]
b = [1, # one
     2]  # why
c.d = 'x'

[e]
f = 1 # last
)";

TEST(ValueOf, FindsValuesAsTheyAreWritten) {
  EXPECT_THAT(value_of(text, "", "title"), Optional(std::string("\"one\"")));
  EXPECT_THAT(value_of(text, "a", "b"), Optional(std::string("[1, # one\n     2]")));
  EXPECT_THAT(value_of(text, "e", "f"), Optional(std::string("1")));
  EXPECT_EQ(value_of(text, "e", "b"), std::nullopt);
  EXPECT_EQ(value_of(text, "", "a"), std::nullopt);
}

TEST(ValueOf, DottedKeysAreOfTheTablesBelow) {
  EXPECT_THAT(value_of(text, "joint", "dofs"), Optional(std::string("[\"1:+X\"]")));
  EXPECT_THAT(value_of(text, "a.c", "d"), Optional(std::string("'x'")));
}

TEST(LinesOf, AreThoseOfKeyAndValue) {
  EXPECT_THAT(lines_of(text, "a", "b"), Optional(ElementsAre(5, 6)));
  EXPECT_THAT(lines_of(text, "", "title"), Optional(ElementsAre(2, 2)));
  EXPECT_EQ(lines_of(text, "a", "no"), std::nullopt);
}

TEST(WithValue, ADottedKeyStaysOne) { EXPECT_EQ(with_value("[a]\nc.d = 1\n", "a.c", "d", "2"), "[a]\nc.d = 2\n"); }

TEST(WithValue, AKeyOfNoTableStandsFirst) {
  EXPECT_EQ(with_value("# of a\n[a]\nb = 1\n", "", "title", "\"x\""), "title = \"x\"\n# of a\n[a]\nb = 1\n");
  EXPECT_EQ(with_value("", "", "title", "1"), "title = 1\n");
}

TEST(WithoutValue, CommentsStay) {
  EXPECT_EQ(without_value("[a]\nb = 1 # why\nc = 2\n", "a", "b"), "[a]\n# why\nc = 2\n");
  EXPECT_EQ(without_value("[a]\nb = [1,\n 2]\nc = 2\n", "a", "b"), "[a]\nc = 2\n");
  EXPECT_EQ(without_value("[a]\nb = 1\n", "a", "d"), "[a]\nb = 1\n");
  EXPECT_EQ(without_value("[a]\n# of b\nb = 1\n", "a", "b"), "[a]\n# of b\n");
}

TEST(WithoutValue, AnEmptyTableGoes) {
  EXPECT_EQ(without_value("[a]\nb = 1\n\n[c]\nd = 2\n", "c", "d"), "[a]\nb = 1\n");
  EXPECT_EQ(without_value("[a] # why\nb = 1\n[c]\nd = 2\n", "a", "b"), "# why\n[c]\nd = 2\n");
  EXPECT_EQ(without_value("b = 1", "", "b"), "");
}

}  // namespace
}  // namespace jointid::gui
