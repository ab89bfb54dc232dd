// Tables as spreadsheets and analysers write them: titles with units, two_rows of units, quotes, decimal commas, keys.
#include <gmock/gmock.h>

#include <numbers>

#include "file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

constexpr double standard_g = 9.80665;

class CsvTitles : public FileTest {
 protected:
  /// One accelerance of 2 − 1i at 10 Hz, 3 + 4i at 20 Hz, in `unit` m/(s²·N).
  void expect_frf(const std::string& content, double unit, const OpenOptions& options = {}) const {
    SCOPED_TRACE(content);
    FrfSet set;
    try {
      set = load(*open(write_file("a.csv", content), options));
    } catch (const InputError& error) {
      FAIL() << error.what();
    }
    ASSERT_EQ(set.header.lines(), 2U);
    EXPECT_EQ(set.header.quantity, Quantity::accelerance);
    const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
    for (std::size_t l = 0; l < 2; ++l) {
      const double hz = 10.0 * static_cast<double>(l + 1), omega = 2.0 * std::numbers::pi * hz;
      EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-12 * hz);
      EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-12 * std::abs(set.values[l]));
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = {}) const {
    return message_of([&] { open(write_file("a.csv", content), options); });
  }
};

const std::string key_line = "# quantity = accelerance\n", two_rows = "10,2,-1\n20,3,4\n",
                  pair_titles = "1:+Z/2:+Z re,1:+Z/2:+Z im\n";

std::string with_separator(std::string text, char separator) {
  std::ranges::replace(text, ',', separator);
  return text;
}

TEST_F(CsvTitles, KeysOfAnySpellingAreRead) {
  for (const char* line :
       {"# unit = g/N", "# Unit = g/N", "# units = g/N", "# UNITS: g/N", "# unit: g/N", "#unit=g/N", "#  Units : G / N "})
    expect_frf("# Quantity: Accelerance\n" + std::string(line) + "\nfrequency_hz," + pair_titles + two_rows, standard_g);
  expect_frf("# unit = g/N\nfrequency_hz," + pair_titles + two_rows, standard_g);  // the unit says the quantity
  expect_frf(key_line + "# measured on = Monday\n# sensor: 352C22\n# a plain comment\nfrequency_hz," + pair_titles + two_rows,
             1.0);
}

TEST_F(CsvTitles, KeysThatAreNearlyOneAreErrors) {
  for (const char* line :
       {"# unut = g/N", "# uint = g/N", "# untis: g/N", "# FRF unit = g/N", "# y-units = g/N", "# response_unit: g"})
    EXPECT_THAT(error(key_line + line + "\nfrequency_hz," + pair_titles + two_rows), HasSubstr("line 2: the key '")) << line;
  EXPECT_THAT(error(key_line + "# FRF unit = g/N\nfrequency_hz," + pair_titles + two_rows),
              HasSubstr("the key 'FRF unit' is not known; did you mean unit?"));
  EXPECT_THAT(error("# quantitiy = accelerance\nfrequency_hz," + pair_titles + two_rows), HasSubstr("did you mean quantity?"));
  EXPECT_THAT(error(key_line + "# unit = g/N\n# units = m/s^2/N\nfrequency_hz," + pair_titles + two_rows),
              HasSubstr("line 3: 'unit' is m/s^2/N here and g/N above"));
  EXPECT_THAT(error(key_line + "# unit = EU/N\nfrequency_hz," + pair_titles + two_rows),
              HasSubstr("# unit: unknown unit 'EU/N'"));
}

TEST_F(CsvTitles, TheFirstColumnAndItsUnit) {
  for (const char* title : {"Frequency [Hz]", "Freq (Hz)", "frequency", "Frequency Hz", "FREQUENCY_HZ", "f [Hz]", "Frequenz [Hz]",
                            "Frequency/Hz", "Hz", "\"Frequency [Hz]\""})
    expect_frf(key_line + title + "," + pair_titles + two_rows, 1.0);
  expect_frf(key_line + "Frequency [kHz]," + pair_titles + "0.01,2,-1\n0.02,3,4\n", 1.0);
  expect_frf(key_line + "Frequency (rpm)," + pair_titles + "600,2,-1\n1200,3,4\n", 1.0);
  expect_frf(key_line + "# frequency_unit = kHz\nFrequency," + pair_titles + "0.01,2,-1\n0.02,3,4\n", 1.0);
  for (const char* title : {"omega", "Frequency [rad/s]", "Freq (rad/sec)"})
    expect_frf(key_line + title + "," + pair_titles + "62.831853071795865,2,-1\n125.66370614359173,3,4\n", 1.0);
  EXPECT_THAT(error(key_line + "Frequency [V]," + pair_titles + two_rows), HasSubstr("line 2, column 1: "));
  EXPECT_THAT(error(key_line + "time [s]," + pair_titles + two_rows),
              HasSubstr("the first column is 'time [s]', so it is no table of FRFs"));
  EXPECT_THAT(error(key_line + "# frequency_unit = kHz\nFrequency [Hz]," + pair_titles + two_rows),
              HasSubstr("the unit 'Hz' is not that of # frequency_unit, 'kHz'"));
}

TEST_F(CsvTitles, UnitsInTitlesAndInARowUnderThem) {
  expect_frf("Frequency [Hz],1:+Z/2:+Z re [g/N],1:+Z/2:+Z im [g/N]\n" + two_rows, standard_g);
  expect_frf("Frequency (Hz),1:+Z/2:+Z re (m/s²)/N,1:+Z/2:+Z im (m/s²)/N\n" + two_rows, 1.0);
  expect_frf("Frequency,1:+Z/2:+Z Real,1:+Z/2:+Z Imag\nHz,g/N,g/N\n" + two_rows, standard_g);
  expect_frf(key_line + "Frequency,1:+Z/2:+Z real,1:+Z/2:+Z imaginary\n[Hz],[mm/s^2/N],[mm/s^2/N]\n" + two_rows, 1e-3);
  expect_frf(key_line + "Frequency," + pair_titles + "Hz,,\n" + two_rows, 1.0);
  const std::string polar = "10,2.23606797749979,-26.56505117707799\n20,5,53.13010235415598\n";
  expect_frf("Frequency [Hz],1:+Z/2:+Z Magnitude [g/N],1:+Z/2:+Z Phase [°]\n" + polar, standard_g);
  expect_frf(key_line + "Frequency [Hz],1:+Z/2:+Z mag,1:+Z/2:+Z phase (deg)\n" + polar, 1.0);
  const auto refused = [&](const std::string& titles, const std::string& units) {
    return error(key_line + titles + "\n" + units + two_rows);
  };
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z re,1:+Z/2:+Z im", "Hz,EU,EU\n"), HasSubstr("line 3, column 2: unknown unit 'EU'"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z re [V/N],1:+Z/2:+Z im [V/N]", ""), HasSubstr("line 2, column 2: unknown unit 'V/N'"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z mag [dB],1:+Z/2:+Z phase_deg", ""), HasSubstr("unknown unit 'dB'"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z re,1:+Z/2:+Z im", "Hz,g/N,m/s^2/N\n"),
              HasSubstr("the parts of one FRF have different units"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z re [g/N],1:+Z/2:+Z im", "Hz,m/s^2/N,m/s^2/N\n"),
              HasSubstr("line 3, column 2: the unit is 'm/s^2/N' here and 'g/N' in the title"));
  EXPECT_THAT(error(key_line + "# unit = g/N\nFrequency,1:+Z/2:+Z re [m/s^2/N],1:+Z/2:+Z im\n" + two_rows),
              HasSubstr("the unit 'm/s^2/N' is not that of # unit, 'g/N'"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z mag,1:+Z/2:+Z phase", ""),
              HasSubstr("does not state whether it is in degrees or radians"));
  EXPECT_THAT(refused("Frequency,1:+Z/2:+Z mag,1:+Z/2:+Z phase_deg [rad]", ""),
              HasSubstr("a column phase_deg in 'rad' is not understood"));
}

TEST_F(CsvTitles, SpreadsheetsOfAnyCountry) {
  const std::string table = "Frequency [Hz]," + pair_titles + "10.0,2.0,-1.0\n20.0,3.0,4.0\n";
  const auto comma = [](std::string text) {
    std::ranges::replace(text, '.', ',');
    return text;
  };
  for (const char separator : {';', '\t'}) {
    expect_frf(key_line + with_separator(table, separator), 1.0);
    expect_frf(key_line + comma(with_separator(table, separator)), 1.0);
  }
  expect_frf(key_line + "Frequency [Hz]\t1:+Z/2:+Z real\t1:+Z/2:+Z imag\n10\t2\t-1\n20\t3\t4\n", 1.0);  // no analyser's text
  expect_frf("sep=;\r\n" + key_line + comma(with_separator(table, ';')), 1.0);
  expect_frf("\xEF\xBB\xBFSEP=,\n" + key_line + table, 1.0);
  expect_frf(
      key_line + "\"Frequency [Hz]\",\"1:+Z/2:+Z re\",\"1:+Z/2:+Z im\"\n\"10,0\",\"2,0\",\"-1,0\"\n\"20,0\",\"3,0\",\"4,0\"\n",
      1.0);
  std::string wide = "\xFF\xFE";
  for (const char c : key_line + with_separator(table, '\t')) wide += {c, '\0'};
  expect_frf(wide, 1.0);
  EXPECT_THAT(error(key_line + "Frequency [Hz]\t1:+Z/2:+Z re\t1:+Z/2:+Z im\n10\t1,234\t5.5\n"),
              HasSubstr("line 3, column 3: '5.5' and line 3 have different decimal signs, comma and point"));
}

TEST_F(CsvTitles, DofsThatAreGivenMustBeThoseOfTheColumns) {
  OpenOptions options;
  options.response = dofs({"1:+Z"});
  options.reference = dofs({"2:+Z"});
  expect_frf(key_line + "frequency_hz," + pair_titles + two_rows, 1.0, options);
  options.response = dofs({"9:+Z"});
  EXPECT_THAT(error(key_line + "frequency_hz," + pair_titles + two_rows, options),
              HasSubstr("line 2, column 1: the columns name their DOFs, 1:+Z, and others are given; leave out the DOFs that are "
                        "given (--response"));
  EXPECT_THAT(error(key_line + "frequency_hz,12X+/12X+ re,12X+/12X+ im\n" + two_rows),
              HasSubstr("line 2, column 2: '12X+' is not a DOF; did you mean 12:+X?"));
}

TEST_F(CsvTitles, OptionsThatDoNotApplyAreErrors) {
  OpenOptions options;
  options.variable = "H";
  const std::string good = key_line + "frequency_hz," + pair_titles + two_rows;
  const auto usage = [&](const OpenOptions& wrong) {
    return message_of([&] { open(write_file("a.csv", good), wrong); }, ErrorKind::usage);
  };
  EXPECT_THAT(
      usage(options),
      HasSubstr("the variable 'H' is named, and a file of format CSV has none; leave out --variable, in a scene variable"));
  options.variable.clear();
  options.frequency_variable = "f";
  EXPECT_THAT(usage(options), HasSubstr("leave out --frequency-variable, in a scene frequency_variable"));
}

}  // namespace
}  // namespace jointid::frf
