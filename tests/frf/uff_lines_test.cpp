#include "frf/uff/uff_lines.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "base/error.hpp"
#include "tests/test_folder.hpp"

namespace jointid::frf {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<NodeLine> lines_in(const std::string& text) {
  const TestFolder folder;
  std::ofstream(folder / "a.uff") << text;
  return read_uff_lines(folder / "a.uff");
}

TEST(UffLines, ATraceLineIsDrawnUntilThePenIsLifted) {
  EXPECT_THAT(lines_in("    -1\n    82\n"
                       "         1        10         0\n"
                       "\n"
                       "         1         2         3         0         7         8         9        10\n"
                       "        11         2\n"
                       "         2         2         0\n"
                       "second\n"
                       "         2         1\n"
                       "    -1\n"),
              ElementsAre(NodeLine{1, 2}, NodeLine{2, 3}, NodeLine{7, 8}, NodeLine{8, 9}, NodeLine{9, 10}, NodeLine{10, 11},
                          NodeLine{11, 2}));
}

TEST(UffLines, ElementsAreDrawnByTheirEdges) {
  const auto lines = lines_in(
      "    -1\n  2412\n"
      "         1        21         1         1         7         2\n"
      "         0         1         1\n"
      "         1         2\n"
      "         2        44         1         1         7         4\n"
      "         1         2         3         4\n"
      "    -1\n");
  EXPECT_THAT(lines, ElementsAre(NodeLine{1, 2}, NodeLine{2, 3}, NodeLine{3, 4}, NodeLine{4, 1}));
}

TEST(UffLines, SolidsHaveTheEdgesOfTheirShape) {
  const auto count = [](const std::string& descriptor, int nodes) {
    std::string text = "    -1\n  2412\n         1" + std::string(10 - descriptor.size(), ' ') + descriptor +
                       "         1         1         7         " + std::to_string(nodes) + "\n";
    for (int i = 1; i <= nodes; ++i) text += "         " + std::to_string(i);
    return lines_in(text + "\n    -1\n").size();
  };
  EXPECT_EQ(count("111", 4), 6U);
  EXPECT_EQ(count("112", 6), 9U);
  EXPECT_EQ(count("115", 8), 12U);
  EXPECT_EQ(count("91", 3), 3U);
  EXPECT_EQ(count("136", 2), 1U);
  EXPECT_EQ(count("116", 8), 0U);
}

TEST(UffLines, OtherDatasetsAndCutOffOnesSayNothing) {
  EXPECT_THAT(lines_in("    -1\n   151\nmodel\n    -1\n"), IsEmpty());
  EXPECT_THAT(lines_in("    -1\n    82\n         1         3         0\n    -1\n"), IsEmpty());
  EXPECT_THAT(lines_in("    -1\n    82\n         1        -3         0\nname\n    -1\n"), IsEmpty());
}

TEST(UffLines, WhatIsNoNumberIsRefused) {
  EXPECT_THROW(lines_in("    -1\n    82\n         1         3         0\nname\n         1      nine         3\n    -1\n"),
               InputError);
  EXPECT_THROW(read_uff_lines("/nowhere/a.uff"), InputError);
}

}  // namespace
}  // namespace jointid::frf
