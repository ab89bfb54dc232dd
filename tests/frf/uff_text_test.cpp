#include "frf/uff/uff_text.hpp"

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <string>

#include "frf/uff/uff_file.hpp"
#include "frf/uff/uff_units.hpp"
#include "frf/uff/uff_write_text.hpp"

namespace jointid::frf::uff {
namespace {

using testing::Optional;

TEST(UffText, RealsWithFortranExponents) {
  EXPECT_THAT(parse_real(" 1.5E+01 "), Optional(15.0));
  EXPECT_THAT(parse_real("1.0D+00"), Optional(1.0));
  EXPECT_THAT(parse_real("-1.25d-02"), Optional(-0.0125));
  EXPECT_THAT(parse_real("1.0+100"), Optional(1e100));
  EXPECT_THAT(parse_real("-1.0-101"), Optional(-1e-101));
  EXPECT_THAT(parse_real("0.00000E+000"), Optional(0.0));
  EXPECT_THAT(parse_real("+3."), Optional(3.0));
  EXPECT_THAT(parse_real(".5"), Optional(0.5));
  EXPECT_THAT(parse_real("1.0-400"), Optional(0.0));
  EXPECT_THAT(parse_real("1.0E-400"), Optional(0.0));
}

/// Against from_chars, to the last bit.
TEST(UffText, ShortRealsAreTheNearestDoubles) {
  std::mt19937_64 random(5);
  const auto exact = [](const std::string& text) {
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  };
  std::size_t taken = 0, all = 0;
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), static_cast<int>(random() % 150) - 140);
    for (const char* format : {"%.5E", "%.5e", "%.12E", "%.3f", "%.17E", "%.8E"}) {
      std::array<char, 400> text{};
      const int size = std::snprintf(text.data(), text.size(), format, value);
      double found = 0.0;
      ++all;
      if (!parse_short_real(text.data(), text.data() + size, found)) continue;
      ++taken;
      ASSERT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(exact(text.data()))) << text.data();
    }
  }
  EXPECT_GT(taken, all / 4);
  for (const std::string text :
       {"0.00000E+00", "-0.00000E+00", "1.", "9007199254740992.", "8.999999999999999E+22", "1.5E+23", "123.456E+5"}) {
    double found = 1.0;
    EXPECT_TRUE(parse_short_real(text.data(), text.data() + text.size(), found)) << text;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(exact(text))) << text;
  }
  for (const std::string text : {"", "-", ".5", "1", "1e5", "1.5E", "1.5E+", "1.5E+-1", "1.5E+0000", "+1.5", "--1.5", "1.5D+01",
                                 "1.5 ", " 1.5", "1..5", "1.5.", "nan", "1.E+23", "9007199254740993.", "9.999999999999999E+22",
                                 "1.0E-23", "0x1.8"}) {
    double found = 0.0;
    EXPECT_FALSE(parse_short_real(text.data(), text.data() + text.size(), found)) << text;
  }
}

TEST(UffText, WhatIsNoReal) {
  for (const char* text : {"", "  ", "+", "-", "E5", "1.0E", "1.0E+400", "1.0 2.0", "1.0E+00-2.0E+00", "+-1",
                           "*************", "1,5"}) {
    EXPECT_FALSE(parse_real(text).has_value()) << text;
  }
}

TEST(UffText, ValuesThatAreNoNumbers) {
  for (const char* text : {"NaN", "nan", "-nan", "1.#QNAN", "-1.#IND", "1.#QNAN0000E+00", "-1.#IND00E+000", "1.#SNAN", "1.#R",
                           "1.$", "1,#QNAN", "nan(ind)", "-nan(ind)", "NaNQ", "*************"}) {
    EXPECT_TRUE(parse_value(text) && std::isnan(*parse_value(text))) << text;
  }
  for (const char* text : {"inf", "Infinity", "1.#INF", "1.#INF00E+000", "1.#J"})
    EXPECT_THAT(parse_value(text), Optional(HUGE_VAL)) << text;
  EXPECT_THAT(parse_value("-1.#INF"), Optional(-HUGE_VAL));
  EXPECT_THAT(parse_value("1.5E+01"), Optional(15.0));
  for (const char* text : {"", "1.#", "1.#QNANx", "-1.#IND0E+00-1.#IND0E+00", "nan(ind)-nan(ind)", "n/a", "**1**", "1.#QNAN 2"})
    EXPECT_FALSE(parse_value(text)) << text;
}

TEST(UffText, Integers) {
  EXPECT_THAT(parse_integer("  -3 "), Optional(-3));
  EXPECT_THAT(parse_integer("+7"), Optional(7));
  EXPECT_THAT(parse_integer("   "), Optional(0));
  EXPECT_FALSE(parse_integer("1.0"));
  EXPECT_FALSE(parse_integer("99999999999999999999"));
}

TEST(UffText, ColumnsCountCharactersNotBytes) {
  EXPECT_EQ(one_byte_per_column("m/s\xC2\xB2 7"), "m/s\xB2 7");  // UTF-8
  EXPECT_EQ(one_byte_per_column("m/s\xB2 7"), "m/s\xB2 7");      // Latin-1
  EXPECT_EQ(one_byte_per_column("\xCE\xBCm"), "?m");             // beyond Latin-1
  EXPECT_EQ(text_column("\xCE\xBCm 7", 0, 2), "\xCE\xBCm");      // kept
  EXPECT_EQ(text_column("m/s\xB2 7", 0, 4), "m/s\xC2\xB2");
  EXPECT_EQ(to_utf8("m/s\xB2"), "m/s\xC2\xB2");
  EXPECT_EQ(column("abc  def", 3, 4), "de");
  EXPECT_EQ(column("abc", 5, 4), "");
}

TEST(UffText, Delimiters) {
  EXPECT_TRUE(is_delimiter("    -1"));
  EXPECT_TRUE(is_delimiter("    -1                  \r"));
  EXPECT_TRUE(is_delimiter(std::string_view("    -1\0\0\x1A", 9)));
  EXPECT_FALSE(is_delimiter("        -1"));  // a field of ten columns
  EXPECT_FALSE(is_delimiter("    -10     0"));
}

TEST(UffText, HeaderNumbersKeepTenDigits) {
  EXPECT_EQ(real_field(400.0), "         400.");
  EXPECT_EQ(real_field(0.390625), "     0.390625");
  for (const double value :
       {1.0 / 3.0, 10.0 / 3.0, 1e4 / 7.0, 0.0012345678912345, 1.23456789e-7, 12345678.912345, 1e25 / 3}) {
    const std::string field = real_field(value);
    EXPECT_EQ(field.size(), 13u);
    EXPECT_EQ(field[0], ' ');
    EXPECT_NEAR(*parse_real(field) / value, 1.0, 1e-6) << field;
  }
  EXPECT_NEAR(*parse_real(real_field(1.0 / 3.0)), 1.0 / 3.0, 1e-10);
}

void expect_unit(const char* label, double si, int length, int time, int force) {
  const auto unit = parse_unit(label);
  ASSERT_TRUE(unit.has_value()) << label;
  EXPECT_NEAR(unit->si / si, 1.0, 1e-14) << label;
  EXPECT_EQ(unit->length, length) << label;
  EXPECT_EQ(unit->time, time) << label;
  EXPECT_EQ(unit->force, force) << label;
}

TEST(UffUnits, Labels) {
  for (const char* label :
       {"m/s^2", "m/s2", "m/s\xC2\xB2", "m/s\xB2", "m/s/s", "m/s**2", "m s^-2", "m/(s*s)", "(m/s^2)"}) {
    expect_unit(label, 1.0, 1, -2, 0);
  }
  expect_unit("g", 9.80665, 1, -2, 0);
  expect_unit("g/N", 9.80665, 1, -2, -1);
  expect_unit("(1/N)*(m/s\xB2)", 1.0, 1, -2, -1);
  expect_unit("mm/s^2/N", 1e-3, 1, -2, -1);
  expect_unit("(mm/s\xC2\xB2)/N", 1e-3, 1, -2, -1);
  expect_unit("m/(s^2*N)", 1.0, 1, -2, -1);
  expect_unit("\xC2\xB5m/kN", 1e-9, 1, 0, -1);
  expect_unit("in/lbf", 0.0254 / 4.4482216152605, 1, 0, -1);
  expect_unit("deg/s", std::numbers::pi / 180.0, 0, -1, 0);
  expect_unit("N*m", 1.0, 1, 0, 1);
  expect_unit("Nm", 1.0, 1, 0, 1);
  expect_unit("1/kg", 1.0, 1, -2, -1);
}

TEST(UffUnits, LabelsNotUnderstood) {
  for (const char* label : {"", "NONE", "V", "dB", "m/", "m/s^", "(m/s^2", "m/s^2)", "2 m", "s 2"}) {
    EXPECT_FALSE(parse_unit(label).has_value()) << label;
  }
}

TEST(UffSniff, FirstBytes) {
  const auto looks = [](std::string_view text) { return looks_like_uff(text); };
  EXPECT_TRUE(looks("    -1\n    58\n"));
  EXPECT_TRUE(looks("\n    -1   \r\n    58b     1     2"));
  EXPECT_FALSE(looks("    -1\n"));
  EXPECT_FALSE(looks("    -1\nfrequency\n"));
  EXPECT_FALSE(looks("frequency,1,2\n"));
  EXPECT_FALSE(looks(""));
  EXPECT_FALSE(looks("\x89HDF\r\n\x1a\n"));
}

}  // namespace
}  // namespace jointid::frf::uff
