
#include "report/text/table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace jointid::cli {
namespace {

TEST(Table, ColumnsAreAlignedAndAsWideAsTheWidestCell) {
  report::Table table({{"name", report::Align::left}, {"value"}});
  table.add({"k", "1"});
  table.add({"a long name", "1e+06"});
  EXPECT_EQ(table.text(), "  name         value\n  k                1\n  a long name  1e+06\n");
}

TEST(Table, WidthsCountCharactersNotBytes) {
  report::Table table({{"", report::Align::left}, {"", report::Align::left}});
  table.add({"–", "x"});
  table.add({"ab", "y"});
  EXPECT_EQ(table.text(0), "–   x\nab  y\n");
}

TEST(Table, LinesDoNotEndInBlanks) {
  report::Table table({{"a", report::Align::left}, {"b", report::Align::left}});
  table.add({"1", ""});
  EXPECT_EQ(table.text(0), "a  b\n1\n");
}

TEST(Number, WhatIsNotFiniteIsADash) {
  EXPECT_EQ(report::number(123456789.0), "1.23457e+08");
  EXPECT_EQ(report::number(0.5), "0.5");
  EXPECT_EQ(report::number(std::numeric_limits<double>::quiet_NaN()), "–");
  EXPECT_EQ(report::number(std::numeric_limits<double>::infinity()), "–");
}

TEST(CsvLine, FieldsThatNeedQuotesGetThem) {
  EXPECT_EQ(report::csv_line({"K(1,2)", "", "say \"k\"", "1"}), "\"K(1,2)\",,\"say \"\"k\"\"\",1\n");
  EXPECT_EQ(report::csv_line({"", "x"}), ",x\n");
}

}  // namespace
}  // namespace jointid::cli
