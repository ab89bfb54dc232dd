#include "cli/text/table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace jointid::cli {
namespace {

TEST(Table, ColumnsAreAlignedAndAsWideAsTheWidestCell) {
  Table table({{"name", Align::left}, {"value"}});
  table.add({"k", "1"});
  table.add({"a long name", "1e+06"});
  EXPECT_EQ(table.text(), "  name         value\n  k                1\n  a long name  1e+06\n");
}

TEST(Table, WidthsCountCharactersNotBytes) {
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"–", "x"});
  table.add({"ab", "y"});
  EXPECT_EQ(table.text(0), "–   x\nab  y\n");
}

TEST(Table, LinesDoNotEndInBlanks) {
  Table table({{"a", Align::left}, {"b", Align::left}});
  table.add({"1", ""});
  EXPECT_EQ(table.text(0), "a  b\n1\n");
}

TEST(Number, WhatIsNotFiniteIsADash) {
  EXPECT_EQ(number(123456789.0), "1.23457e+08");
  EXPECT_EQ(number(0.5), "0.5");
  EXPECT_EQ(number(std::numeric_limits<double>::quiet_NaN()), "–");
  EXPECT_EQ(number(std::numeric_limits<double>::infinity()), "–");
}

TEST(CsvLine, FieldsThatNeedQuotesGetThem) {
  EXPECT_EQ(csv_line({"K(1,2)", "", "say \"k\"", "1"}), "\"K(1,2)\",,\"say \"\"k\"\"\",1\n");
  EXPECT_EQ(csv_line({"", "x"}), ",x\n");
}

}  // namespace
}  // namespace jointid::cli
