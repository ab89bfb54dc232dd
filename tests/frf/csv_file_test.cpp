#include "frf/csv/csv_file.hpp"

#include <gmock/gmock.h>

#include <numbers>

#include "file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

class CsvFile : public FileTest {
 protected:
  FrfSet read(const std::string& content, const OpenOptions& options = {}) const {
    return load(*open_csv(write_file("a.csv", content), options));
  }
  std::string error(const std::string& content, const OpenOptions& options = {}) const {
    return message_of([&] { read(content, options); });
  }
};

TEST_F(CsvFile, RoundTripsEveryQuantityAndNoiseRecord) {
  std::mt19937 random(11);
  for (int trial = 0; trial < 5; ++trial) {
    for (const Quantity quantity : all_quantities) {
      for (const NoiseRecord noise : all_noise_records) {
        const FrfSet set = random_set(random, quantity, noise, trial % 2 == 0);
        write_csv(set, path("a.csv"));
        expect_same(load(*open_csv(path("a.csv"))), set, quantity == Quantity::receptance ? 0.0 : 1e-15);
        EXPECT_EQ(files_in_folder(), 1u);
      }
    }
  }
}

TEST_F(CsvFile, KeepsPositions) {
  std::mt19937 random(12);
  FrfSet set = random_set(random, Quantity::mobility, NoiseRecord::none);
  set.header.nodes = {{4, {0.1, -2.5e-3, 0.0}}, {10, {1.0 / 3.0, 2.0, 3.0}}};
  write_csv(set, path("a.csv"));
  const auto nodes = open_csv(path("a.csv"))->header().nodes;
  ASSERT_EQ(nodes.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(nodes[i].id, set.header.nodes[i].id);
    EXPECT_EQ(nodes[i].position, set.header.nodes[i].position);
  }
  const std::string rest = "# quantity = receptance\nfrequency_hz, 4:+Y/1:+Y re, 4:+Y/1:+Y im\n1, 2, 3\n";
  EXPECT_EQ(read("# node 7 = 1, 2; 3\n" + rest).header.nodes.front().position, (std::array{1.0, 2.0, 3.0}));
  EXPECT_THAT(error("# node 7 = 1 2\n" + rest), HasSubstr("# node 7: has 2 numbers, not three; write node number and position in m"));
  EXPECT_THAT(error("# node x = 1 2 3\n" + rest), HasSubstr("# node x: 'x' is not a node number"));
  EXPECT_THAT(error("# node 7 = 1 2 z\n" + rest), HasSubstr("# node 7: 'z' is not a number"));
}

TEST_F(CsvFile, ReadsTheDocumentedLayoutWithEverySeparator) {
  const std::string text =
      "# a comment\n# quantity = receptance\n# unit = mm/N\n\n"
      "frequency_hz, 4:+Y/1:+Y re, 4:+Y/1:+Y im, 5:-Y/1:+Y mag, 5:-Y/1:+Y phase_deg\n"
      "10.0, 1.5, -2e-3, 2, 90\n20, , 1, +3, NaN\n";
  const auto with = [&](char separator, bool decimal_comma) {
    std::string other = text;
    for (char& c : other) c = c == ',' ? separator : c;
    for (char& c : other) c = decimal_comma && c == '.' ? ',' : c;
    return other;
  };
  for (const std::string& spelling : {with(',', false), with(';', false), with('\t', false), with(';', true),
                                      "\xEF\xBB\xBF" + with(';', true)}) {
    const FrfSet set = read(spelling);
    EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 20.0}));
    EXPECT_EQ(set.header.response, dofs({"4:+Y", "5:-Y"}));
    EXPECT_EQ(set.header.reference, dofs({"1:+Y"}));
    EXPECT_TRUE(near(set.values[0], {1.5e-3, -2e-6}, 1e-15));
    EXPECT_TRUE(near(set.values[1], {0.0, 2e-3}, 1e-15));
    EXPECT_TRUE(std::isnan(set.values[2].real()) && std::isnan(set.values[2].imag()));
    EXPECT_TRUE(std::isnan(set.values[3].real()));
  }
}

TEST_F(CsvFile, APairWithoutColumnsIsNotMeasured) {
  const FrfSet set = read(
      "# quantity = receptance\r\nfrequency_hz,1:X/1:X re,1:X/1:X im,2:X/2:X re,2:X/2:X im\r\n1,1,0,2,0\r\n");
  ASSERT_EQ(set.values.size(), 4u);
  EXPECT_EQ(set.values[0], Complex(1.0, 0.0));
  EXPECT_TRUE(std::isnan(set.values[1].real()));
  EXPECT_TRUE(std::isnan(set.values[2].real()));
  EXPECT_EQ(set.values[3], Complex(2.0, 0.0));
}

TEST_F(CsvFile, QuantityAndDofsMayComeFromOptions) {
  OpenOptions options;
  options.quantity = Quantity::accelerance;
  options.response = dofs({"1:+X", "2:+X"});
  options.reference = dofs({"3:+Y"});
  const FrfSet set = read("frequency_hz,re,im,re,im\n1,1,0,2,0\n", options);
  EXPECT_EQ(set.header.response, options.response);
  EXPECT_EQ(set.header.reference, options.reference);
  const double omega = 2.0 * std::numbers::pi;
  EXPECT_TRUE(near(set.values[1], {-2.0 / (omega * omega), 0.0}, 1e-15));
}

TEST_F(CsvFile, WhatIsWrongIsNamedByLineAndColumn) {
  const std::string q = "# quantity = receptance\n";
  const std::string h = q + "frequency_hz,1:X/1:X re,1:X/1:X im\n";
  EXPECT_THAT(error(h + "1,2,3\n2,x,4\n"), HasSubstr("a.csv: line 4, column 2: 'x' is not a number"));
  EXPECT_THAT(error(h + "1,2,1e999\n"), HasSubstr("line 3, column 3: '1e999' is not a number"));
  EXPECT_THAT(error(h + "1,2,inf\n"), HasSubstr("line 3, column 3: 'inf' is not a number"));
  EXPECT_THAT(error(h + "1,2\n"), HasSubstr("line 3, column 2: the line has 2 cells and the header 3"));
  EXPECT_THAT(error(h + ",2,3\n"), HasSubstr("line 3, column 1: no frequency"));
  EXPECT_THAT(error(h + "2,2,3\n1,2,3\n"), HasSubstr("frequencies must increase"));
  EXPECT_THAT(error(h), HasSubstr("frequency: no lines"));
  EXPECT_THAT(error(q), HasSubstr("no header row"));
  EXPECT_THAT(error(q + "x,1:X/1:X re\n"), HasSubstr("line 2, column 1: the first column is 'x'"));
  EXPECT_THAT(error(q + "frequency_hz\n"), HasSubstr("no column but the frequency"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:X reel\n"),
              HasSubstr("column 2: '1:X/1:X reel' is not a column of an FRF"));
  EXPECT_THAT(error(q + "frequency_hz,1:X re\n"), HasSubstr("column 2: '1:X' is not response/reference"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:Q re\n"), HasSubstr("line 2, column 2: '1:Q' is not a DOF"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:X re,1:X/1:X re\n"),
              HasSubstr("column 3: '1:X/1:X re' is there twice"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:X re,im\n"),
              HasSubstr("column 3: columns with and without DOFs"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:X re\n"),
              HasSubstr("the columns of 1:+X/1:+X are no complete FRF"));
  EXPECT_THAT(error(q + "frequency_hz,1:X/1:X re,1:X/1:X phase_deg\n"), HasSubstr("are no complete FRF"));
  EXPECT_THAT(error(q + "frequency_hz,re,im\n"),
              HasSubstr("'re' has no DOFs, and 0 responses and 0 references"));
}

/// In time that grows with their number; a table that is mostly gaps, and one of more columns, is refused.
TEST_F(CsvFile, ManyColumns) {
  const auto table = [](int pairs, bool one_reference) {
    std::string titles = "frequency_hz", row = "10";
    for (int k = 1; k <= pairs; ++k) {
      const std::string pair = std::to_string(k) + ":+Z/" + std::to_string(one_reference ? 1 : k) + ":+Z ";
      titles += "," + pair + "re," + pair + "im", row += ",1,2";
    }
    return "# quantity = accelerance\n" + titles + "\n" + row + "\n";
  };
  EXPECT_EQ(open(write_file("a.csv", table(20'000, true)))->header().response.size(), 20'000u);
  EXPECT_THAT(message_of([&] { open(write_file("b.csv", table(50'000, true))); }),
              testing::HasSubstr("100001 columns are more than the 100000"));
  EXPECT_THAT(message_of([&] { open(write_file("c.csv", table(1'000, false))); }),
              testing::HasSubstr("whose FRFs are mostly not there"));
}

TEST_F(CsvFile, AMagnitudeBelowZeroIsNamed) {
  EXPECT_THAT(error("# quantity = receptance\nfrequency_hz,1:X/1:X mag,1:X/1:X phase_deg\n1,2,3\n2,-1e-6,3\n"),
              HasSubstr("line 4, column 2: the magnitude -1e-06 is below 0"));
}

/// Twelve lines of magnitude 1 whose phases are `share` of a whole turn and less, in a unit of `turn` to the whole.
std::string phases(const std::string& part, double share, double turn) {
  std::string text = "# quantity = receptance\nfrequency_hz,1:X/1:X mag,1:X/1:X " + part + "\n";
  for (int line = 1; line <= 12; ++line) text += std::to_string(line) + ",1," + std::to_string(-share * turn * line / 12.0) + "\n";
  return text;
}

TEST_F(CsvFile, RadiansThatAreCalledDegreesAreNotTakenForThem) {
  const double whole_turn = 2.0 * std::numbers::pi;
  EXPECT_THAT(error(phases("phase_deg", 0.5, whole_turn)), HasSubstr("as if they were radians; name the columns phase_rad"));
  const FrfSet radians = read(phases("phase_rad", 0.5, whole_turn)), degrees = read(phases("phase_deg", 0.5, 360.0));
  for (std::size_t i = 0; i < 12; ++i) EXPECT_TRUE(near(radians.values[i], degrees.values[i], 1e-6));
  EXPECT_TRUE(degrees.header.doubts.empty());
  EXPECT_EQ(read(phases("phase_deg", 2.0 / 360.0, 360.0)).header.doubts.size(), 1u);  // small phases, of a stiffness line perhaps
  EXPECT_TRUE(read(phases("phase_deg", 0.5 / 360.0, 360.0)).header.doubts.empty());
  EXPECT_THAT(error("# quantity = receptance\nfrequency_hz,1:X/1:X mag,1:X/1:X phase_deg,1:X/1:X phase_rad\n1,1,1,1\n"),
              HasSubstr("are no complete FRF"));
}

TEST_F(CsvFile, WhatTheCommentsSayIsChecked) {
  const std::string h = "frequency_hz,1:X/1:X re,1:X/1:X im";
  EXPECT_THAT(error(h + "\n1,2,3\n"), HasSubstr("does not state which quantity it holds"));
  EXPECT_THAT(error("# quantity = compliance\n" + h + "\n1,2,3\n"),
              HasSubstr("# quantity: unknown FRF quantity 'compliance'"));
  EXPECT_THAT(error("# quantity = receptance\n# unit = m/s\n" + h + "\n1,2,3\n"),
              HasSubstr("# unit: unit 'm/s' is not a unit of receptance"));
  EXPECT_THAT(error("# quantity = receptance\n# averages = many\n" + h + ",1:X/1:X coherence\n1,2,3,0.9\n"),
              HasSubstr("# averages: 'many' is not a number of averages"));
  EXPECT_THAT(error("# quantity = receptance\n" + h +
                    ",1:X/1:X coherence,1:X/1:X var_re,1:X/1:X var_im\n1,2,3,1,1,1\n"),
              HasSubstr("has both variances and coherences"));
}

}  // namespace
}  // namespace jointid::frf
