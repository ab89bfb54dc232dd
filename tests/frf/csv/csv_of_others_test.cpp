// Tables as LabVIEW, analysers, pandas, MATLAB and spreadsheets leave them: free lines above the titles, row numbers, complex
// cells, error words. Accelerances of 2 − 1i and 3 + 4i m/(s²·N) at 10 and 20 Hz in every file.
#include <gmock/gmock.h>

#include <numbers>

#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double gravity = 9.80665;

class CsvOfOthers : public FileTest {
 protected:
  FrfSet read(const std::string& content, const OpenOptions& options) const {
    try {
      return load(*open(write_file("a.csv", content), options));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
      return {};
    }
  }
  void expect_right(const std::string& content, double unit, const OpenOptions& options) const {
    const FrfSet set = read(content, options);
    ASSERT_EQ(set.header.lines(), 2U) << content;
    EXPECT_EQ(set.header.quantity, Quantity::accelerance) << content;
    const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
    for (std::size_t l = 0; l < 2; ++l) {
      const double hz = 10.0 * static_cast<double>(l + 1), omega = 2.0 * std::numbers::pi * hz;
      EXPECT_NEAR(set.header.frequency_hz[l], hz, 1e-12 * hz) << content;
      EXPECT_LE(std::abs(set.values[l] + unit * right[l] / (omega * omega)), 1e-12 * std::abs(set.values[l])) << content;
    }
  }
  std::string error(const std::string& content, const OpenOptions& options, ErrorKind kind = ErrorKind::data) const {
    return message_of([&] { open(write_file("a.csv", content), options); }, kind);
  }
};

OpenOptions at_one_point() {
  OpenOptions options;
  options.response = options.reference = dofs({"1:+Z"});
  return options;
}

OpenOptions accelerance(OpenOptions options = {}) {
  options.quantity = Quantity::accelerance;
  return options;
}

OpenOptions points(const std::vector<std::string>& responses, const std::vector<std::string>& references) {
  OpenOptions options;
  options.response = dofs(responses);
  options.reference = dofs(references);
  return options;
}

const std::string numbers = "10,2,-1\n20,3,4\n", own_titles = "frequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n";

TEST_F(CsvOfOthers, FreeLinesStandAboveTheTitles) {
  const std::string table = "Frequency (Hz),Real (g/N),Imag (g/N)\n" + numbers;
  for (const char* above :
       {"Measurement,Hammer test\nDate,2024-01-01\n\n", "Test: beam; run 3\nDate: 01.02.2024 10:00\n",
        "Waveform Information\nChannel:,AI1\nSample rate,2048\n----\n", "\"Export of, everything\"\n\"2024\"\n",
        "1.0,2.0\nserial,3,4,5,6\n", "Frequency,1000\nFrequency range,0 - 1000 Hz\n", "Frequency response of beam, run 2\n",
        "# made by hand\nFree text.\n"})
    expect_right(above + table, gravity, at_one_point());
  expect_right("A title\r\n\r\nFrequency\tReal\tImag\r\nHz\tg/N\tg/N\r\n10\t2\t-1\r\n20\t3\t4\r\n\x1A", gravity, at_one_point());
  expect_right("Titel;x\nFrequenz [Hz];Realteil [m/s²/N];Imaginärteil [m/s²/N]\n10,0;2,0;-1,0\n20,0;3,0;4,0\n", 1.0,
               at_one_point());
  // What two titles of one FRF of an analyser's export are called.
  expect_right("File: a.dxd\n\nFrequency\tAI 1/AI 2 Real\tAI 1/AI 2 Imag\nHz\tg/N\tg/N\n10\t2\t-1\n20\t3\t4\n", gravity,
               at_one_point());
}

TEST_F(CsvOfOthers, AnUnknownUnitIsNamedBeforeTheQuantityThatItDoesNotTell) {
  EXPECT_THAT(error("frequency_hz,1:+Z/1:+Z re [blorp/N],1:+Z/1:+Z im [blorp/N]\n" + numbers, {}),
              AllOf(HasSubstr("'blorp/N' is no unit of an FRF that is known"), HasSubstr("--unit g/N")));
}

TEST_F(CsvOfOthers, CellsMayStandBetweenBlanks) {
  const std::string rows = "1.0e+01 2.0e+00 -1.0e+00\n2.0e+01 3.0e+00 4.0e+00\n";
  for (const char* titles :
       {"Frequency Real Imag\n", "# Frequency, Real, Imag\n", "% Freq [Hz]  Re  Im\n", "Beam run 3\n\nFrequency (Hz) Real Imag\n",
        "# run 3\n# quantity = accelerance\n# Frequency   Real H1   Imag H1\n"})
    expect_right(titles + rows, 1.0, accelerance(at_one_point()));
  expect_right("# frequency_hz 1:+Z/1:+Z re 1:+Z/1:+Z im\n" + rows, 1.0, accelerance());
  expect_right("Frequency [Hz] Re [g/N] Im [g/N]\n   10  2  -1\n\n   20  3   4  \n", gravity, at_one_point());
  expect_right("frequency_hz 1:+Z/1:+Z re [g/N] 1:+Z/1:+Z im [g/N]\r\n10 2 -1\r\n20 3 4\r\n", gravity, {});
  expect_right("Frequency Real Imag\nkHz g/N g/N\n0,01 2,0 -1,0\n0,02 3,0 4,0\n", gravity, at_one_point());
  expect_right("# frequency_hz 1:+Z/1:+Z\n10 (2-1j)\n20 (3+4j)\n", 1.0, accelerance());
  expect_right("No. Frequency Real Imag\n1 10 2 -1\n2 20 3 4\n", 1.0, accelerance(at_one_point()));
}

TEST_F(CsvOfOthers, BlanksThatLeaveItOpenWhatACellIsAreRefused) {
  EXPECT_THAT(error("Frequency,Real,Imag\n10,1 000,2 000\n20,1 000,2 000\n", accelerance(at_one_point())),
              HasSubstr("'1 000' is not a number"));
  EXPECT_THAT(error("Frequency Real Imag\n10 2 -1\n15 3\n20 3 4\n", accelerance(at_one_point())),
              HasSubstr("line 3, column 2: the line has 2 cells and the header 3"));
  EXPECT_THAT(error("Frequency Real part of H Imag part of H\n10 2 -1\n20 3 4\n", accelerance(at_one_point())),
              HasSubstr("the line has 3 cells and the header 9"));
  EXPECT_THAT(error("10 2 -1\n20 3 4\n", accelerance(at_one_point())), HasSubstr("the numbers have no row of titles above them"));
}

TEST_F(CsvOfOthers, UnitsInFreeLinesAreReadOrRefused) {
  const std::string table = own_titles + numbers;
  for (const char* line : {"Units,g/N", "Unit;g/N", "Y Unit: g/N", "Amplitude (Y) = g/N", "g/N", "Engineering Units,g/N,,"})
    expect_right(std::string(line) + "\n" + table, gravity, {});
  expect_right("Quantity,accelerance\nAverages,10\nX Unit,kHz\nfrequency,1:+Z/1:+Z re,1:+Z/1:+Z im\n0.01,2,-1\n0.02,3,4\n", 1.0,
               {});
  EXPECT_THAT(error("Unit,mV/N\n" + table, accelerance()),
              AllOf(HasSubstr("line 1: 'mV/N' is no unit of an FRF that is known"), HasSubstr("--unit g/N, in a scene unit")));
  EXPECT_THAT(error("x,1\nResponse unit: g\n" + table, accelerance()), HasSubstr("line 2: 'g' is no unit of an FRF"));
  EXPECT_THAT(error("Scale,dB\n" + table, accelerance()), HasSubstr("line 1: 'dB' is no unit"));
  EXPECT_THAT(error("Unit,g/N\nY unit,m/s^2/N\n" + table, {}),
              HasSubstr("line 2: the unit is 'm/s^2/N' here and 'g/N' elsewhere"));
  OpenOptions given;
  given.unit = "g/N";
  expect_right("Unit,mV/N\n" + table, gravity, given);
  expect_right("Sensor unit,g\nFrequency (Hz),Real (g/N),Imag (g/N)\n" + numbers, gravity, at_one_point());
}

TEST_F(CsvOfOthers, AGivenUnitStandsInPlaceOfAnyOther) {
  OpenOptions given;
  given.unit = "g/N";
  for (const char* unit : {"-", "V/N", "EU", "1", "n/a", "a.u.", "m/s^2/N"})
    expect_right("Frequency [Hz],1:+Z/1:+Z re [" + std::string(unit) + "],1:+Z/1:+Z im [" + unit + "]\n" + numbers, gravity,
                 given);
  expect_right("# y-axis: g/lbf\n# FRF unit = V\n" + own_titles + numbers, gravity, given);
  EXPECT_THAT(error("Frequency [Hz],1:+Z/1:+Z re [-],1:+Z/1:+Z im [-]\n" + numbers, accelerance()),
              AllOf(HasSubstr("line 1, column 2: "), HasSubstr("'-'"), HasSubstr("--unit")));
  expect_right("Frequency,1:+Z/1:+Z re (g)(N),1:+Z/1:+Z im (g)(N)\n" + numbers, gravity, {});
}

TEST_F(CsvOfOthers, AColumnThatCountsTheRowsIsPassedOver) {
  for (const char* title : {"", "Unnamed: 0", "index", "#", "No.", "Line", "\"\""})
    expect_right(std::string(title) + "," + own_titles + "0,10,2,-1\n1,20,3,4\n", 1.0, accelerance());
  expect_right("Point;Frequency;Re;Im\n;Hz;g/N;g/N\n1;10;2;-1\n2;20;3;4\n", gravity, at_one_point());
  expect_right("frequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im,\n10,2,-1,\n20,3,4,\n", 1.0, accelerance());
  expect_right(own_titles + "10,2,-1,,\n20,3,4,,\n", 1.0, accelerance());
  EXPECT_THAT(error("," + own_titles + "0,10,2,x\n", accelerance()), HasSubstr("line 2, column 4: 'x' is not a number"));
}

TEST_F(CsvOfOthers, ComplexCells) {
  const std::string titles = "frequency_hz,1:+Z/1:+Z\n";
  for (const auto& [first, second] :
       {std::pair("2-1j", "3+4j"), std::pair("(2-1j)", "(3+4j)"), std::pair("2.0e0-1.0E+00i", "3+0.4e1i"),
        std::pair("2 - 1i", "3 + 4i"), std::pair("2-j1", "3+j4"), std::pair("2-1*I", "3+4*I"), std::pair("2 - 1im", "3 + 4im"),
        std::pair("[2-1j]", "[3+4J]"), std::pair("\"(2.0,-1.0)\"", "\"(3.0,4.0)\"")})
    expect_right(titles + "10," + first + "\n20," + second + "\n", 1.0, accelerance());
  expect_right("Frequency [Hz];H11 [g/N]\n10,0;2,0-1,0i\n20,0;3,0+4,0i\n", gravity, at_one_point());
  expect_right(",freq,H11\n0,10,(2-1j)\n1,20,(3+4j)\n", 1.0, accelerance(at_one_point()));
  const FrfSet gaps = read(titles + "1,nan+nanj\n2,\n3,NaN\n4,5\n10,2-1j\n", accelerance());
  ASSERT_EQ(gaps.values.size(), 5U);
  for (std::size_t l = 0; l < 3; ++l) EXPECT_TRUE(std::isnan(gaps.values[l].real()) && std::isnan(gaps.values[l].imag()));
  EXPECT_EQ(gaps.values[3].imag(), 0.0);
  EXPECT_LT(gaps.values[3].real(), 0.0);
  EXPECT_THAT(error("frequency_hz,1:+Z/1:+Z re\n10,2-1j\n", accelerance()),
              HasSubstr("line 1, column 2: '1:+Z/1:+Z re' names a part and holds complex numbers"));
  for (const char* cell : {"inf+1j", "2-1k", "2-j", "(2,5)", "j", "1+2"})
    EXPECT_THAT(error(titles + "10," + cell + ",\n", accelerance()), HasSubstr("line 2, column 2: ")) << cell;
}

TEST_F(CsvOfOthers, ErrorWordsOfSpreadsheetsAreNotMeasured) {
  for (const char* word : {"#DIV/0!", "#N/A", "#NUM!", "#VALUE!", "#NAME?", "#WERT!", "#NV", "N/A", "NA", "<NA>", "NULL", "None",
                           "-", "--", "#####", "1.#QNAN", "-1.#IND", "Err:502", "nan"}) {
    const FrfSet set = read(own_titles + "5," + word + "," + word + "\n" + numbers, accelerance());
    ASSERT_EQ(set.values.size(), 3U) << word;
    EXPECT_TRUE(std::isnan(set.values[0].real()) && !std::isnan(set.values[1].real())) << word;
  }
  EXPECT_THAT(error(own_titles + "#DIV/0!,1,2\n" + numbers, accelerance()), HasSubstr("line 2, column 1: no frequency"));
  for (const char* word : {"inf", "x", "?", "overload"})
    EXPECT_THAT(error(own_titles + "5," + word + ",1\n", accelerance()), HasSubstr("is not a number")) << word;
}

TEST_F(CsvOfOthers, TheUnitOfTheFrequenciesCanBeGiven) {
  OpenOptions given = accelerance();
  given.frequency_unit = "kHz";
  for (const char* title : {"Frequency [Bogus]", "Frequency [Hz]", "X-Axis", "Abscissa", "f"})
    expect_right(std::string(title) + ",1:+Z/1:+Z re,1:+Z/1:+Z im\n0.01,2,-1\n0.02,3,4\n", 1.0, given);
  EXPECT_THAT(error("X-Axis,1:+Z/1:+Z re,1:+Z/1:+Z im\n" + numbers, accelerance()),
              AllOf(HasSubstr("the first column is 'X-Axis'"), HasSubstr("--frequency-unit Hz, in a scene frequency_unit")));
  given.frequency_unit = "parsec";
  EXPECT_THAT(error(own_titles + numbers, given), HasSubstr("'parsec' is no unit of frequency"));
}

std::string lvm(const std::string& columns, const std::string& dimension, const std::string& rest) {
  return "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t.\nMulti_Headings\tNo\nX_Columns\t" +
         columns + "\n***End_of_Header***\t\n\t\nChannels\t2\t\t\nSamples\t2\t2\t\nY_Unit_Label\tg/N\tDegrees\t\nX_Dimension\t" +
         dimension + "\t" + dimension + "\t\nX0\t10.0\t10.0\t\nDelta_X\t10.0\t10.0\t\n***End_of_Header***\t\t\t\n" + rest;
}

TEST_F(CsvOfOthers, LabViewMeasurementFiles) {
  const std::string polar = "2.23606797749979\t-26.56505117707799", polar_2 = "5\t53.13010235415598";
  expect_right(lvm("One", "Frequency", "X_Value\tMag\tPhase\tComment\n10\t" + polar + "\tfirst\n20\t" + polar_2 + "\t\n"),
               gravity, at_one_point());
  expect_right(lvm("No", "Frequency", "X_Value\tFRF (Magnitude)\tFRF (Phase)\tComment\n\t" + polar + "\t\n\t" + polar_2 + "\t\n"),
               gravity, at_one_point());
  expect_right(lvm("Multi", "Frequency",
                   "X_Value\tMag\tX_Value\tPhase\tComment\n10\t2.23606797749979\t10\t-26.56505117707799\n"
                   "20\t5\t20\t53.13010235415598\n"),
               gravity, at_one_point());
  EXPECT_THAT(error(lvm("One", "Time", "X_Value\tMag\tPhase\n0\t1\t2\n"), at_one_point()),
              AllOf(HasSubstr("X_Dimension: is over 'Time'"), HasSubstr("jointid frf")));
  EXPECT_THAT(error(lvm("One", "Frequency", "X_Value\tMag\tPhase\n10\tx\t2\n"), at_one_point()),
              HasSubstr("line 17: 'x' is not a number"));
  EXPECT_THAT(error(lvm("Multi", "Frequency", "X_Value\tMag\tX_Value\tPhase\n10\t1\t11\t2\n"), at_one_point()),
              HasSubstr("channels 1 and 2 have different X_Value"));
  EXPECT_THAT(error(lvm("One", "Frequency", ""), at_one_point()), HasSubstr("has no row of titles that begins with X_Value"));
  std::string rows = "X_Value\tMag\tPhase\n";
  for (const char* hz : {"10", "20", "30", "40", "50", "60"}) rows += std::string(hz) + "\t2.00000\t-26.56505\n";
  EXPECT_THAT(error(lvm("One", "Frequency", rows.substr(0, rows.size() - 4)), at_one_point()), HasSubstr("the last line has no end"));
}

TEST_F(CsvOfOthers, FactorsThatNothingAppliesAndConjugatesAreErrors) {
  const std::string table = "Frequency (Hz),Real (g/N),Imag (g/N)\n" + numbers;
  for (const char* line :
       {"# scale = 0.001\n", "# Scale factor: 1e-3\n", "scale,0.001\n", "# multiply by 1e-3\n", "# values x 1e-3\n"})
    EXPECT_THAT(error(line + table, at_one_point()), HasSubstr("which is not applied to the FRFs")) << line;
  for (const char* line : {"# convention: exp(-j*omega*t)\n", "# conjugate of FRF\n"})
    EXPECT_THAT(error(line + table, at_one_point()), HasSubstr("conjugates of FRFs of exp(+iωt)")) << line;
  for (const char* line :
       {"# scale = 1\n", "# sensitivity: 10 mV/g\n", "# full scale = 10\n", "Gain,10\n", "# 5 times per point\n"})
    expect_right(line + table, gravity, at_one_point());
}

/// Of programs that name a component before node and direction, or write these without a colon.
TEST_F(CsvOfOthers, DofsAsOthersWriteThemAreOfThoseThatAreGiven) {
  const OpenOptions pair = accelerance(points({"1:+Z", "2:+Z"}, {"1:+Z"}));
  const auto titled = [](const std::string& first, const std::string& second) {
    return "frequency_hz," + first + " re," + first + " im," + second + " re," + second + " im\n10,2,-1,5,6\n20,3,4,7,8\n";
  };
  for (const auto& [first, second] : {std::pair("FRF plate:1:+Z/plate:1:+Z", "FRF plate:2:+Z/plate:1:+Z"),
                                      std::pair("1Z+/1Z+", "2Z+/1Z+"), std::pair("H1 1Z+/1Z+", "H1 2Z+/1Z+")}) {
    const FrfSet set = read(titled(first, second), pair);
    ASSERT_EQ(set.values.size(), 4U) << first;
    EXPECT_NEAR(std::abs(set.values[1]) * std::pow(20.0 * std::numbers::pi, 2), std::abs(Complex(5.0, 6.0)), 1e-9) << first;
    EXPECT_THAT(error(titled(second, first), pair), HasSubstr("is of 2:+Z by its title, and 1:+Z was given for it")) << first;
    EXPECT_THAT(error(titled(first, second), accelerance()), HasSubstr("--response 4:+Y --reference 1:+Y")) << first;
  }
}

TEST_F(CsvOfOthers, RowsOfChannelsWithUnitsThatNothingReadsAreErrors) {
  const std::string above =
      "Channel,Datatype,Unit,Length\nFrequency,DT_DOUBLE,Hz,2\nReal,DT_DOUBLE,g/N,2\nImaginary,DT_DOUBLE,g/N,2\n";
  EXPECT_THAT(error(above + "Frequency,Real,Imaginary\n" + numbers, accelerance(at_one_point())),
              AllOf(HasSubstr("line 3"), HasSubstr("states the unit 'g/N', which is not read"), HasSubstr("--unit")));
}

/// The word before a DOF states which of the two is excited; FRFs were transposed before.
TEST_F(CsvOfOthers, WordsBeforeDofsStateTheReference) {
  const auto pair_of = [&](const std::string& title) {
    const FrfSet set = read("frequency_hz\t" + title + " re\t" + title + " im\n10\t2\t-1\n20\t3\t4\n", accelerance());
    return set.header.response.at(0).name() + "/" + set.header.reference.at(0).name();
  };
  EXPECT_EQ(pair_of("Hammer 1:+Z, Accelerometer 2:+Z"), "2:+Z/1:+Z");
  EXPECT_EQ(pair_of("Shaker 1:+Z, Sensor 2:+Z"), "2:+Z/1:+Z");
  EXPECT_EQ(pair_of("Accelerometer 2:+Z, Hammer 1:+Z"), "2:+Z/1:+Z");
  EXPECT_EQ(pair_of("2:+Z/1:+Z"), "2:+Z/1:+Z");
}

TEST_F(CsvOfOthers, TitlesOfTwoDofsWithoutAStrokeAreHeldAgainstThoseThatAreGiven) {
  const OpenOptions pair = accelerance(points({"1:+Z", "2:+Z"}, {"1:+Z"}));
  EXPECT_THAT(error("frequency_hz,FRF 2Z 1Z re,FRF 2Z 1Z im,FRF 1Z 1Z re,FRF 1Z 1Z im\n10,2,-1,5,6\n20,3,4,7,8\n", pair),
              HasSubstr("is of 2:+Z by its title, and 1:+Z was given for it"));
  EXPECT_EQ(
      read("frequency_hz,FRF 1Z 1Z re,FRF 1Z 1Z im,FRF 2Z 1Z re,FRF 2Z 1Z im\n10,2,-1,5,6\n20,3,4,7,8\n", pair).values.size(),
      4U);
}

TEST_F(CsvOfOthers, ConjugatesOfComplexCellsAreErrorsByTheirTitle) {
  EXPECT_THAT(error("frequency_hz,conj 1:+Z/1:+Z\n10,2+1j\n20,3-4j\n", accelerance()),
              HasSubstr("is of the conjugate of an FRF"));
}

TEST_F(CsvOfOthers, SingleQuotesAreNamed) {
  EXPECT_THAT(error("'frequency_hz','1:+Z/1:+Z re','1:+Z/1:+Z im'\n'10','2','-1'\n", accelerance()),
              HasSubstr("cells are in single quotes, 'frequency_hz'; remove these"));
}

/// The last number was cut off, which no other line shows: it was read as another number.
TEST_F(CsvOfOthers, AFileThatBreaksOffInANumber) {
  std::string text = "frequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n";
  for (const char* hz : {"10", "20", "30", "40", "50", "60"}) text += std::string(hz) + ",2.00000e+00,-1.12345e+01\n";
  const std::string cut = text.substr(0, text.size() - 5), unended = text.substr(0, text.size() - 1);
  EXPECT_THAT(error(cut, accelerance()),
              HasSubstr("line 7, column 3: the last line has no end, and its last number has fewer digits"));
  EXPECT_EQ(read(unended, accelerance()).values.size(), 6U);
  EXPECT_EQ(read(cut + "\n", accelerance()).values.size(), 6U) << "an end of the line";
  EXPECT_EQ(read("frequency_hz,1:+Z/1:+Z re,1:+Z/1:+Z im\n10,2.12,-1.5\n20,3.25,4.75\n30,1.125,2.5\n40,1.5,3.25\n50,2,3.5",
                 accelerance())
                .values.size(),
            5U);
}

}  // namespace
}  // namespace jointid::frf
