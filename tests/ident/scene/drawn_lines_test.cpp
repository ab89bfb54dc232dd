#include "ident/scene/drawn_lines.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"
#include "ident/scene/couple_scene.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::ident {
namespace {

using frf::NodeLine;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string least =
    "[data]\nsubstructures = ['a', 'b']\nassembly = ['c']\n[joint]\ndofs = ['1:+X', '2:+X']\n"
    "[joint.stiffness]\npattern = 'full'\n";

std::string error_of(const std::string& geometry) {
  try {
    parse_scene(least + geometry, "scene.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(DrawnLines, ArePairsOfNodes) {
  EXPECT_EQ(error_of("[geometry]\nlines = [[1, 2], [2, 5]]\n"), "");
  EXPECT_THAT(readable_lines(least + "[geometry]\nlines = [[1, 2], [2, 5]]\n"), ElementsAre(NodeLine{1, 2}, NodeLine{2, 5}));
  EXPECT_THAT(readable_lines(least), IsEmpty());
}

TEST(DrawnLines, AreReadWhateverElseIsWrong) {
  EXPECT_THAT(readable_lines("nonsense = 1\n[geometry]\nlines = [[7, 9]]\n"), ElementsAre(NodeLine{7, 9}));
  EXPECT_THAT(readable_lines("no TOML"), IsEmpty());
}

TEST(DrawnLines, WhatIsNoLineIsAnErrorAtItsPlace) {
  EXPECT_THAT(error_of("[geometry]\nlines = [[1, 2, 3]]\n"),
              testing::AllOf(HasSubstr("[geometry] lines[1]"), HasSubstr("found 3")));
  EXPECT_THAT(error_of("[geometry]\nlines = [[4, 4]]\n"), HasSubstr("from node 4 to itself"));
  EXPECT_THAT(error_of("[geometry]\nlines = [[1.5, 2]]\n"), HasSubstr("not a whole number"));
  EXPECT_THAT(error_of("[geometry]\nline = [[1, 2]]\n"), HasSubstr("is not known here"));
}

TEST(DrawnLines, OfScenesOfCouplingToo) {
  const std::string couple = "[data]\nparts = ['a', 'b']\n[couple]\njoin = [['1:+X', '2:+X']]\n[geometry]\nlines = ";
  EXPECT_NO_THROW(parse_couple_scene(couple + "[[1, 2]]", "scene.toml"));
  EXPECT_THROW(parse_couple_scene(couple + "[[1]]", "scene.toml"), InputError);
}

}  // namespace
}  // namespace jointid::ident
