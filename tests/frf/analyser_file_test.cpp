#include "frf/csv/analyser_file.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "file_fixture.hpp"
#include "tests/require.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// As an analyser writes it: Latin-1, CR/LF, tabs.
std::string exported(const std::string& channels, const std::string& unit, const std::string& rows) {
  return "Units: Ratio\r\nRef Chan:Resp Chan\t" + channels + "\r\nChannel Name\t : \r\nChannel Comment\t : \r\n\r\n" +
         "Frequency\t Real\t Imaginary\r\n\r\nUnits:\r\nHz\t" + unit + "\t \r\n" + rows;
}

OpenOptions of_quantity(Quantity quantity) {
  OpenOptions options;
  options.quantity = quantity;
  return options;
}

OpenOptions of_dofs(const std::vector<Dof>& response, const std::vector<Dof>& reference) {
  OpenOptions options;
  options.response = response;
  options.reference = reference;
  return options;
}

class AnalyserFile : public FileTest {
 protected:
  FrfSet read(const std::string& content, const OpenOptions& options = {}) const {
    return load(*open(write_file("a.txt", content), options));
  }
  std::string error(const std::string& content, const OpenOptions& options = {}) const {
    return message_of([&] { read(content, options); });
  }
};

TEST_F(AnalyserFile, IsReadAsTheAnalyserWroteIt) {
  const FrfSet set =
      read(exported("1+Z:4-Z", "(m/s\xB2)(N)", "0.0e+000\t -0.5\t 0\r\n1.0e+001\t -0.25\t 0.125\r\n2.0e+001\t\t 1\r\n"));
  EXPECT_EQ(set.header.frequency_hz, (std::vector{0.0, 10.0, 20.0}));
  EXPECT_EQ(set.header.response, dofs({"4:-Z"}));
  EXPECT_EQ(set.header.reference, dofs({"1:+Z"}));
  EXPECT_EQ(set.header.quantity, Quantity::accelerance);
  EXPECT_TRUE(std::isnan(set.values[0].real()));
  const double omega = 20.0 * std::numbers::pi;
  EXPECT_TRUE(near(set.values[1], Complex(-0.25, 0.125) / -(omega * omega), 1e-15));
  EXPECT_TRUE(std::isnan(set.values[2].real()));
}

TEST_F(AnalyserFile, TheUnitTellsTheQuantityAndTheFactor) {
  const std::string row = "10\t 2\t 0\r\n";
  EXPECT_EQ(read(exported("1+Z:4Z", "(m/s)(N)", row)).header.quantity, Quantity::mobility);
  const FrfSet receptance = read(exported("1+Z:4Z", "(mm)(kN)", row));
  EXPECT_EQ(receptance.header.quantity, Quantity::receptance);
  EXPECT_NEAR(receptance.values[0].real(), 2e-6, 1e-20);
  const FrfSet in_g = read(exported("1+Z:4Z", "(g)(N)", row)), in_si = read(exported("1+Z:4Z", "(m/s^2)(N)", row));
  EXPECT_NEAR(in_g.values[0].real() / in_si.values[0].real(), 9.80665, 1e-12);
  EXPECT_EQ(read(exported("1+Z:4Z", "", row), of_quantity(Quantity::mobility)).header.quantity, Quantity::mobility);
  EXPECT_THAT(error(exported("1+Z:4Z", "", row)), HasSubstr("does not state which quantity it holds"));
  EXPECT_THAT(error(exported("1+Z:4Z", "(V)(N)", row)), HasSubstr("unknown unit '(V)/(N)'"));
}

TEST_F(AnalyserFile, UnitsOfOtherAnalysers) {
  const std::string row = "10\t 2\t 0\r\n";
  const double plain = read(exported("1+Z:4Z", "(m/s^2)(N)", row)).values[0].real();
  EXPECT_NEAR(read(exported("1+Z:4Z", "(G)(LBF)", row)).values[0].real() / plain, 9.80665 / 4.4482216152605, 1e-14);
  EXPECT_NEAR(read(exported("1+Z:4Z", "(g rms)(N rms)", row)).values[0].real() / plain, 9.80665, 1e-13);
  EXPECT_NEAR(read(exported("1+Z:4Z", "(IN/S^2)(lbs)", row + "\x1A")).values[0].real() / plain, 0.0254 / 4.4482216152605, 1e-14);
  EXPECT_THAT(error(exported("1+Z:4Z", "(m/s^2)(V)", row)), HasSubstr("V is a voltage"));
  OpenOptions said;
  said.unit = "g/lbf";
  EXPECT_NEAR(read(exported("1+Z:4Z", "(V)(V)", row), said).values[0].real() / plain, 9.80665 / 4.4482216152605, 1e-14);
  EXPECT_NEAR(read("Ref Chan:Resp Chan\t1Z:2Z\nFrequency\tReal\tImaginary\nrad/sec\t(m)(N)\n1\t2\t3\n").header.frequency_hz[0],
              0.5 / std::numbers::pi, 1e-16);
}

TEST_F(AnalyserFile, DofsMayBeGivenWhereTheLabelsSayNothing) {
  const std::string row = "10\t 2\t 0\r\n";
  const OpenOptions given = of_dofs(dofs({"4:-X"}), dofs({"1:+X"}));
  const FrfSet set = read(exported("0-Z:0-Z", "(m/s\xB2)(N)", row), given);
  EXPECT_EQ(set.header.response, given.response);
  EXPECT_EQ(set.header.reference, given.reference);
  EXPECT_THAT(error(exported("Ch 1:Ch 2", "(m/s\xB2)(N)", row)),
              HasSubstr("does not state the DOFs of FRF 1 ('Ch 1:Ch 2'); give them"));
  EXPECT_THAT(error(exported("1+Z:4Z", "(m)(N)", row), of_dofs(dofs({"1:+X", "2:+X"}), dofs({"1:+X"}))),
              HasSubstr("holds 1 FRFs, and 2 responses and 1 references were given"));
}

TEST_F(AnalyserFile, HoldsSeveralFrfsSideBySide) {
  const FrfSet set = read(
      "Resp Chan:Ref Chan\t4-Z:1+Z\t5Z:1+Z\nFrequency\tReal\tImaginary\tReal\tImaginary\nHz\t(m)/(N)\t\t(m)/(N)\t\n"
      "10\t1,5\t0\t2\t-1\n");
  EXPECT_EQ(set.header.response, dofs({"4:-Z", "5:+Z"}));
  EXPECT_EQ(set.header.reference, dofs({"1:+Z"}));
  EXPECT_EQ(set.values[0], Complex(1.5, 0.0));
  EXPECT_EQ(set.values[1], Complex(2.0, -1.0));
}

TEST_F(AnalyserFile, WhatDoesNotFitIsNamedWithItsLine) {
  const std::string unit = "(m/s\xB2)(N)";
  EXPECT_THAT(error(exported("1+Z:4Z", unit, "10\t 2\r\n")), HasSubstr("line 10: has 2 cells, the headings 3"));
  EXPECT_THAT(error(exported("1+Z:4Z", unit, "10\t 2\t x\r\n")), HasSubstr("line 10, column 3: 'x' is not a number"));
  EXPECT_THAT(error(exported("1+Z:4Z", unit, "")), HasSubstr("holds no lines of numbers"));
  EXPECT_THAT(error("Frequency\tReal\tPhase\n10\t1\t2\n"), HasSubstr("not Real and Imaginary"));
  EXPECT_THAT(error("Ref Chan:Resp Chan\t1Z:2Z\nFrequency\tReal\tImaginary\norder\t(m)(N)\n1\t2\t3\n"),
              HasSubstr("line 3: 'order' is no unit of frequency that is known"));
}

TEST_F(AnalyserFile, AMeasuredExportIsThatOfTheBeam) {
  const auto folder = std::filesystem::path(JOINTID_EXTERNAL_DATA) / "beam-accelerances";
  if (!std::filesystem::exists(folder / "analyser_export.txt")) JOINTID_SKIP(folder << " is missing: no external data");
  const FrfSet text = load(*open(folder / "analyser_export.txt")), beam = load(*open(folder / "beam.h5"));
  EXPECT_EQ(text.header.quantity, Quantity::accelerance);
  EXPECT_EQ(text.header.reference, dofs({"0:-Z"}));
  ASSERT_EQ(text.header.lines(), 2500u);
  const auto first = std::ranges::find_if(text.header.frequency_hz, [](double f) { return f >= 20.0; });
  const auto offset = static_cast<std::size_t>(first - text.header.frequency_hz.begin());
  std::size_t same = 0;
  for (std::size_t column = 0; column < 5; ++column) {
    bool all = true;
    for (std::size_t line = 0; line + offset < text.header.lines(); ++line) {
      all = all && near(text.values[offset + line], beam.values[beam.index(line, 0, column)], 1e-6);
    }
    same += all ? 1 : 0;
  }
  EXPECT_EQ(same, 1u);
}

/// Labels above the headings were passed over, units among them: FRFs in g/N were read as m/s^2/N without a word.
TEST_F(AnalyserFile, LabelsStateUnitsWhereNoRowDoes) {
  OpenOptions given = of_dofs(dofs({"4:+Z"}), dofs({"1:+Z"}));
  given.quantity = Quantity::accelerance;
  const std::string rows = "Frequency\tReal\tImaginary\n10\t2\t-1\n20\t3\t4\n";
  const auto first = [&](const std::string& labels) { return read(labels + rows, given).values.at(0); };
  const Complex plain = first("");
  constexpr double gravity = 9.80665;
  for (const char* labels :
       {"Y-axis unit:\tg/N\n", "Amplitude unit: g/N\n", "Einheit: g/N\n", "Header Size:\t12\nX unit\tHz\nY unit\tg/N\n"})
    EXPECT_TRUE(near(first(labels), gravity * plain, 1e-12)) << labels;
  EXPECT_EQ(read("X unit: kHz\nY unit: m/s^2/N\n" + rows, given).header.frequency_hz, (std::vector{10000.0, 20000.0}));
  for (const auto& [labels, named] :
       {std::pair("Y unit: EU\n", "EU"), std::pair("Response unit: g\nReference unit: N\n", "'g'"),
        std::pair("Y unit: V/V\n", "V/V"), std::pair("Response channel: 2 (g)\n", "states the unit 'g'"),
        std::pair("Scale factor: 2\n", "factor 2"), std::pair("Sign convention: exp(-iwt)\n", "conjugates"),
        std::pair("Y unit: N/(m/s^2)\n", "N/(m/s^2)")})
    EXPECT_THAT(error(labels + rows, given), HasSubstr(named)) << labels;
  EXPECT_THAT(read("Y multiplier 1e-3\nY unit: m/s^2/N\n" + rows, given).header.doubts,
              testing::ElementsAre(HasSubstr("Y multiplier 1e-3")));
  EXPECT_THAT(read(exported("1+Z:4-Z", "(g)(N)", "10\t1\t0\n")).header.doubts, testing::IsEmpty()) << "Units: Ratio";
}

}  // namespace
}  // namespace jointid::frf
