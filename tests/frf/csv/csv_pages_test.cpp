// Tables as people paste and print them: between pipes, with words below the numbers and between pages, polar cells, decibels,
// exponents of Fortran, line ends of old systems. Accelerances of 2 − 1i and 3 + 4i m/(s²·N) at 10 and 20 Hz in every file.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "frf/text/thousands.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

OpenOptions one_point() {
  OpenOptions options;
  options.response = options.reference = dofs({"1:+Z"});
  return options;
}

class CsvPages : public FileTest {
 protected:
  void expect_right(const std::string& content, double unit = 1.0, std::size_t lines = 2) const {
    FrfSet set;
    try {
      set = load(*open(write_file("a.csv", content), one_point()));
    } catch (const InputError& error) {
      FAIL() << error.what() << "\n" << content;
    }
    ASSERT_EQ(set.header.lines(), lines) << content;
    EXPECT_EQ(set.header.quantity, Quantity::accelerance) << content;
    const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
    for (std::size_t l = 0; l < 2; ++l) {
      const double hz = 10.0 * static_cast<double>(l + 1), omega = 2.0 * std::numbers::pi * hz;
      EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-12 * hz) << content;
      EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-12 * std::abs(set.values[l])) << content;
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = one_point()) const {
    return message_of([&] { open(write_file("a.csv", content), options); }, ErrorKind::data);
  }
};

const std::string page_titles = "Frequency [Hz];Real [m/s²/N];Imag [m/s²/N]\n", page_rows = "10;2;-1\n20;3;4\n";
constexpr double standard_gravity = 9.80665;

TEST_F(CsvPages, BetweenPipes) {
  expect_right("| Frequency [Hz] | Real [m/s²/N] | Imag [m/s²/N] |\n|---:|:---:|---|\n| 10 | 2 | -1 |\n| 20 | 3 | 4 |\n");
  expect_right("# Notes\n\nFrequency|Real|Imag\nHz|g/N|g/N\n10|2|-1\n20|3|4\n", standard_gravity);
  expect_right(
      "+---+---+---+\n| f [Hz] | Re [m/s²/N] | Im [m/s²/N] |\n+===+===+===+\n| 10,0 | 2,0 | -1,0 |\n| 20,0 | 3,0 | 4,0 "
      "|\n+---+---+---+\n");
  expect_right(
      "┌───┬───┬───┐\n│ Frequency [Hz] │ Real [m/s²/N] │ Imag [m/s²/N] │\n├───┼───┼───┤\n│ 10 │ 2 │ -1 │\n│ 20 │ 3 │ 4 "
      "│\n└───┴───┴───┘\n");
  EXPECT_THAT(error("|f [Hz]|Real [m/s²/N]|Imag [m/s²/N]|\n|10|2|-1|\n|20|3|\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("2 cells")));
  EXPECT_THAT(error("|f [Hz]|Real [V/N]|Imag [V/N]|\n|10|2|-1|\n|20|3|4|\n"), HasSubstr("V/N"));
}

TEST_F(CsvPages, WordsBelowTheNumbers) {
  for (const char* below : {"End of data\n", "End of data;;\n", "\n\n-----\nEOF\n", "Averages;10\n", "<EOF>\n", ";;\n;;\n",
                            "[2 rows x 3 columns]\n", "Page 1 of 1\n", "Units: m/s²/N\n"})
    expect_right(page_titles + page_rows + below);
  expect_right("Frequency [Hz];Real;Imag\n" + page_rows + "Units: g/N\n", standard_gravity);
  expect_right("Frequency [Hz] Real [g/N] Imag [g/N]\n10 2 -1\n20 3 4\nEnd of file\n", standard_gravity);
  expect_right(page_titles + "10;2;-1\nPage 1 of 2\n\f" + page_titles + "20;3;4\n- 2 -\n");
  EXPECT_THAT(error("Frequency [Hz];Real;Imag\n" + page_rows + "Units: V/V\n"), HasSubstr("V/V"));
  EXPECT_THAT(error(page_titles + page_rows + "Units: g/N\n"), HasSubstr("g/N"));
  EXPECT_THAT(error(page_titles + "10;2;-1\noverload\n20;3;4\n"),
              AllOf(HasSubstr("line 3"), HasSubstr("overload"), HasSubstr("#")));
  EXPECT_THAT(error(page_titles + page_rows + "Max;3;4\n"), AllOf(HasSubstr("line 4"), HasSubstr("Max")));
  EXPECT_THAT(error(page_titles + page_rows + "30;3\n"), HasSubstr("line 4"));
  EXPECT_THAT(error(page_titles + page_rows + "3O;1;2\n"), HasSubstr("'3O' is not a number"));
  const auto source = open(write_file("a.csv", page_titles + page_rows + "Overload in channel 3\n"), one_point());
  ASSERT_EQ(source->header().doubts.size(), 1U);
  EXPECT_THAT(source->header().doubts[0], HasSubstr("Overload in channel 3"));
}

TEST_F(CsvPages, WordsBelowTheNumbersOfAnAnalyser) {
  const std::string above = "Units: Ratio\nRef Chan:Resp Chan\t1+Z:1+Z\nFrequency\t Real\t Imaginary\n";
  const std::string table = above + "\nUnits:\nHz\t(m/s²)(N)\t \n10\t2\t-1\n20\t3\t4\n";
  expect_right(table + "\nEnd of Data\n");
  expect_right(above + "10\t2\t-1\n20\t3\t4\nY Unit:\tg/N\n", standard_gravity);
  EXPECT_THAT(error(above + "10\t2\t-1\n20\t3\t4\nUnits:\tV/V\n"), HasSubstr("V/V"));
  EXPECT_THAT(error(table + "Note\n30\t1\t1\n"), HasSubstr("line 9"));
}

TEST_F(CsvPages, PolarCells) {
  const std::string title = "Frequency [Hz];H [m/s²/N]\n";
  const auto table = [&](const std::string& sign, double per_radian, const std::string& unit) {
    std::string text = title;
    for (const auto& [hz, value] : {std::pair{10, Complex(2, -1)}, {20, Complex(3, 4)}})
      text += std::to_string(hz) + ";" +
              fmt::format("{:.17g}{}{:.17g}{}\n", std::abs(value), sign, per_radian * std::arg(value), unit);
    return text;
  };
  constexpr double degrees = 180.0 / std::numbers::pi;
  for (const auto& [sign, unit] : {std::pair{"∠", "°"}, {" ∠ ", " deg"}, {" @ ", ""}, {"/_", "º"}, {"@", "\xB0"}})
    expect_right(table(sign, degrees, unit));
  for (const auto& [sign, unit] : {std::pair{"∠", "rad"}, {" @ ", " rad"}, {"*exp(", "j)"}, {" * exp(j*", ")"}, {"·e^(j", ")"}})
    expect_right(table(sign, 1.0, unit));
  EXPECT_THAT(error(table("∠", 1.0, "")), AllOf(HasSubstr("line 2, column 2"), HasSubstr("degrees or radians")));
  EXPECT_THAT(error(title + "10;-2∠45°\n"), HasSubstr("is not a number"));
}

TEST_F(CsvPages, DecibelsWithAReference) {
  const auto table = [](const std::string& unit, double reference) {
    std::string text = "Frequency [Hz];Magnitude [" + unit + "];Phase [rad]\n";
    for (const auto& [hz, value] : {std::pair{10, Complex(2, -1)}, {20, Complex(3, 4)}})
      text += fmt::format("{};{:.17g};{:.17g}\n", hz, 20.0 * std::log10(std::abs(value) / reference), std::arg(value));
    return text;
  };
  expect_right(table("dB re 1 m/s²/N", 1.0));
  expect_right(table("dB re 1e-6 m/s²/N", 1e-6));
  expect_right(table("dB (re g/N)", standard_gravity));
  expect_right("# unit = dB re 1 g/N\n" + table("", standard_gravity));
  for (const char* unit : {"dB", "dB re 1 V/V", "dB re 0 m/s²/N", "dBV"}) EXPECT_THAT(error(table(unit, 1.0)), HasSubstr(unit));
  OpenOptions given = one_point();
  given.unit = "m/s^2/N";
  EXPECT_THAT(error(table("dB", 1.0), given), HasSubstr("decibels"));
  EXPECT_THAT(error("Frequency [Hz];Real [dB re 1 g/N];Imag [dB re 1 g/N]\n" + page_rows), HasSubstr("not in decibels"));
}

TEST_F(CsvPages, NumbersOfOtherPrograms) {
  expect_right(page_titles + "1.0D+01;2.0d0;-1.0D+00\n.2D2;3D0;4.0D+0\n");
  expect_right(page_titles + "10;2;−1\n20;3;4\u00a0\n30;1.5-103;1.5+100\n", 1.0, 3);
  expect_right("f [Hz]  Re [m/s²/N]  Im [m/s²/N]\n 1.0D+01  2.0D+00 -1.0D+00\n 2.0D+01  3.0D+00  4.0D+00\n");
  expect_right(page_titles + "10;2;-1\n20;3;4\n1,000.5;1.5;2.5\n", 1.0, 3);
  expect_right(page_titles + "10;2;-1\n20;3;4\n1'000;1.5;2.5\n", 1.0, 3);
  EXPECT_THAT(error(page_titles + "990;2;-1\n1,000;3;4\n"), AllOf(HasSubstr("line 3"), HasSubstr("thousands")));
  EXPECT_THAT(error(page_titles + "10;2.5;-1\n1,000;3;4\n"), HasSubstr("decimal signs"));
}

TEST(Thousands, MarksBetweenGroups) {
  for (const auto& [cell, plain] :
       {std::pair{"1,234.5", "1234.5"}, {"-1.234.567,25", "-1234567.25"}, {"1'234", "1234."}, {"1\u202f234,5", "1234.5"}})
    EXPECT_EQ(without_thousands(cell).value_or("none"), plain) << cell;
  for (const char* cell : {"1,234", "1.234", "12,34.5", "1,234,56", "1 234", "1234", "1,234.5e3", "a", "", "1,,234.5"})
    EXPECT_FALSE(without_thousands(cell)) << cell;
}

TEST_F(CsvPages, LineEndsAndTails) {
  const auto ends = [](std::string text, const std::string& end) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + end.size()))
      text.replace(at, 1, end);
    return text;
  };
  for (const char* end : {"\r", "\r\n", "\r\r\n"}) expect_right(ends(page_titles + page_rows, end));
  expect_right(page_titles + "10;2;-1\r20;3;4\r\n");
  expect_right(page_titles + page_rows + "\x1A\r\n" + std::string(2, '\0'));
  const std::string analyser =
      "Units: Ratio\nRef Chan:Resp Chan\t1+Z:1+Z\nFrequency\t Real\t Imaginary\nHz\tm/s^2/N\t \n10\t2\t-1\n20\t3\t4\n";
  expect_right(ends(analyser, "\r"));
  expect_right(analyser + std::string(100, '\0'));
  std::string wide = "\xFF\xFE";
  for (const char c : ends(analyser, "\r\n")) wide += {c, '\0'};
  expect_right(wide);
}

}  // namespace
}  // namespace jointid::frf
