#include "gui/forms/field_text.hpp"

#include <gtest/gtest.h>

namespace jointid::gui {
namespace {

std::string shown(ValueKind kind, const std::string& value) { return shown_value(kind, value).text; }

TEST(FieldText, StringsAreShownWithoutQuotes) {
  EXPECT_EQ(shown(ValueKind::text, R"("two \"beams\"")"), R"(two "beams")");
  EXPECT_EQ(shown(ValueKind::word, "'auto'"), "auto");
  EXPECT_EQ(written_value(ValueKind::text, R"(two "beams")"), R"("two \"beams\"")");
  EXPECT_EQ(written_value(ValueKind::text, "  "), "");
}

TEST(FieldText, ListsAreShownWithCommas) {
  EXPECT_EQ(shown(ValueKind::dofs, "[\"4:+Y\",\n  '5:+Y', ]"), "4:+Y, 5:+Y");
  EXPECT_EQ(written_value(ValueKind::dofs, "4:+Y,5:+Y, "), "[\"4:+Y\", \"5:+Y\"]");
  EXPECT_EQ(shown(ValueKind::texts, ""), "");
  EXPECT_EQ(shown(ValueKind::texts, "[]"), "");
}

TEST(FieldText, WhatAListOfNamesCannotSayStaysToml) {
  const std::string repeats = R"([["a.uff", "b.uff"], "c.uff"])";
  EXPECT_EQ(shown(ValueKind::texts, repeats), repeats);
  EXPECT_EQ(written_value(ValueKind::texts, repeats), repeats);
  EXPECT_EQ(shown(ValueKind::texts, R"(["a, b.uff"])"), R"(["a, b.uff"])");
  EXPECT_EQ(shown(ValueKind::text, R"("a\tb")"), R"("a\tb")");
  EXPECT_EQ(shown(ValueKind::number, "\"x\""), "\"x\"");
}

TEST(FieldText, AnIntervalNeedsNoBrackets) {
  EXPECT_EQ(written_value(ValueKind::interval, "400, 1000"), "[400, 1000]");
  EXPECT_EQ(written_value(ValueKind::interval, "[400, 1000]"), "[400, 1000]");
}

TEST(FieldText, ValuesWithCommentsAreLeftToTheText) {
  EXPECT_TRUE(shown_value(ValueKind::dofs, "[\"1:+X\", # left\n \"2:+X\"]").is_locked);
  EXPECT_FALSE(shown_value(ValueKind::texts, "[\"a#1.uff\"]").is_locked);
}

TEST(FieldText, MatricesStandInOneLine) { EXPECT_EQ(shown(ValueKind::value, "[[1, 2],\n\n   [3, 4]]"), "[[1, 2], [3, 4]]"); }

TEST(FieldText, CellsOfASpreadsheetArePasted) {
  EXPECT_EQ(pasted_cells(ValueKind::dofs, "4:+Y\t5:+Y\n"), "4:+Y, 5:+Y");
  EXPECT_EQ(pasted_cells(ValueKind::texts, "a.uff\r\nb.uff\r\n"), "a.uff, b.uff");
  EXPECT_EQ(pasted_cells(ValueKind::value, "1e6\t-a\n-a\t2.5\n"), "[[1e6, \"-a\"], [\"-a\", 2.5]]");
}

}  // namespace
}  // namespace jointid::gui
