// Rows between titles and numbers, and titles of which only a unit shows that frequencies come first, as catman, Test.Lab, DIAdem,
// NVGate, DEWESoft and SignalCalc write them. Accelerances of 2 − 1i and 3 + 4i at 10 and 20 Hz, in units of standard gravity over N.
#include <gmock/gmock.h>

#include <array>
#include <numbers>

#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class CsvRowsAbove : public FileTest {
 protected:
  static OpenOptions given(const std::vector<std::string>& response = {"1:+Z"}, const std::vector<std::string>& reference = {"1:+Z"}) {
    OpenOptions options;
    options.response = dofs(response), options.reference = dofs(reference);
    return options;
  }
  static constexpr const char* numbers = "10\t2\t-1\n20\t3\t4\n";

  void expect_right(const std::string& content, const OpenOptions& options = given()) const {
    try {
      const FrfSet set = load(*open(write_file("a.csv", content), options));
      ASSERT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 20.0})) << content;
      const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
      for (std::size_t l = 0; l < 2; ++l) {
        const double omega = 2.0 * std::numbers::pi * set.header.frequency_hz[l];
        EXPECT_LE(std::abs(set.values[l] + 9.80665 * right[l] / (omega * omega)), 1e-4 * std::abs(set.values[l])) << content;
      }
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = given()) const {
    return message_of([&] { open(write_file("a.csv", content), options); });
  }
};

TEST_F(CsvRowsAbove, OfFormatsAndWords) {
  const std::string titles = "Frequency\tReal\tImag\n", units = "Hz\tg/N\tg/N\n", formats = "Format=0.000\tFormat=\t\n";
  expect_right(titles + units + formats + numbers);
  expect_right(titles + formats + units + numbers);
  expect_right(titles + units + "\thammer test\thammer test\n" + numbers);
  expect_right(titles + "\thammer test\thammer test\n" + units + numbers);
  expect_right("Frequency [Hz]\tReal [g/N]\tImag [g/N]\n" + formats + numbers);
  for (const char* unknown : {"smoots per newton", "counts / N", "V rms", "dB re what"})
    EXPECT_NE(error(titles + "\t" + unknown + "\t" + unknown + "\n" + numbers), "nothing was thrown") << unknown;
}

TEST_F(CsvRowsAbove, OfUnitsBesideTitlesWithoutFrequency) {
  const std::string units = "Hz\tg/N\tg/N\n";
  for (const char* titles : {"Linear\tReal\tImag\n", "X\tY Real\tY Imag\n", "\tReal\tImag\n", "x-axis\tFRF Real\tFRF Imaginary\n"}) {
    expect_right(units + titles + numbers);
    expect_right(titles + units + numbers);
    expect_right("Copied from Display1\n" + units + titles + numbers);
  }
  expect_right("X Unit\tHz\nY Unit\tg/N\nX\tY(Real)\tY(Imaginary)\n" + std::string(numbers));
  OpenOptions hertz = given();
  hertz.frequency_unit = "Hz";
  expect_right("X\tReal [g/N]\tImag [g/N]\n" + std::string(numbers), hertz);
  EXPECT_THAT(error("X\tReal [g/N]\tImag [g/N]\n" + std::string(numbers)),
              AllOf(HasSubstr("line 1"), HasSubstr("the first column is 'X'"), HasSubstr("--frequency-unit Hz")));
  EXPECT_THAT(error("Speed\tReal\tImag\nHz\tg/N\tg/N\n" + std::string(numbers)), HasSubstr("the first column is 'Speed [Hz]'"));
  EXPECT_THAT(error("X\tReal\tImag\ns\tg/N\tg/N\n" + std::string(numbers)), HasSubstr("the first column is 'X [s]'"));
}

TEST_F(CsvRowsAbove, OfTitlesWithOtherSigns) {
  for (const char* titles :
       {"Frequency (Hz)\tTF_1Z/1Z/Re (g/N)\tTF_1Z/1Z/Im (g/N)\n", "Frequency (Hz)\tH1; Real (g/N)\tH1; Imag (g/N)\n",
        "Freq [Hz]\tH2,1(f) Re [g/N]\tH2,1(f) Im [g/N]\n", "Frequency <Hz>\tReal <g/N>\tImag <g/N>\n",
        "Frequency | Hz\tReal | g/N\tImag | g/N\n", "Frequency [unit: Hz]\tReal [unit: g/N]\tImag [unit: g/N]\n",
        "Frequency (in Hz)\tReal (in g/N)\tImag (in g/N)\n", "Frequency: Hz\tReal: g/N\tImag: g/N\n",
        "Frequency [Hz]\tY:FRF1 Real [g/N]\tY:FRF1 Imag [g/N]\n"})
    expect_right(titles + std::string(numbers));
  const std::string polar = "10\t2.2360680\t-26.565051\n20\t5\t53.130102\n";
  const std::string levels = "10\t6.9897000\t-26.565051\n20\t13.979400\t53.130102\n";
  expect_right("FREQ\tUZ Amplitude [g/N]\tUZ Phase Angle [°]\n" + polar);
  expect_right("Frequency [Hz]\tLevel dB (re 1 g/N)\tPhase [deg]\n" + levels);
  expect_right("Frequency [Hz]\tMagnitude [dB/1.0 g/N]\tPhase [deg]\n" + levels);
  expect_right("  FREQ            1  UZ\n                 UZ_1\n      REAL     IMAGINARY\n  10  2  -1\n  20  3  4\n", [] {
    OpenOptions options = given();
    options.unit = "g/N", options.frequency_unit = "Hz";
    return options;
  }());
}

TEST_F(CsvRowsAbove, RealAndImaginaryPartsBesideMagnitudes) {
  const std::string titles = "Frequency [Hz]\tReal [g/N]\tImag [g/N]\tMagnitude [g/N]\tPhase [deg]\n";
  expect_right(titles + "10\t2\t-1\t2.2360680\t-26.565051\n20\t3\t4\t5\t53.130102\n");
  EXPECT_THAT(error(titles + "10\t2\t-1\t2.2360680\t-26.565051\n20\t3\t4\t6\t53.130102\n"),
              AllOf(HasSubstr("line 3, column 4"), HasSubstr("the magnitude 6 is not that of the real and imaginary part, 5")));
}

TEST_F(CsvRowsAbove, MoreDofsThanFrfs) {
  const std::string content = "Frequency [Hz]\tReal [g/N]\tImag [g/N]\n" + std::string(numbers);
  EXPECT_THAT(error(content, given({"1:+Z", "2:+Z"})),
              AllOf(HasSubstr("hold 1 FRFs, and 2 responses and 1 references were given, which are 2"), HasSubstr("--response")));
  EXPECT_THAT(error("Frequency [Hz]\tReal [g/N]\tImag [g/N]\tReal [g/N]\tImag [g/N]\n10\t2\t-1\t2\t-1\n20\t3\t4\t3\t4\n",
                    given({"1:+Z", "2:+Z"}, {})),
              HasSubstr("2 references (the responses) were given, which are 4"));
}

TEST_F(CsvRowsAbove, FrequenciesInARow) {
  EXPECT_THAT(error("Frequency [Hz]\t10\t20\nReal [g/N]\t2\t3\nImag [g/N]\t-1\t4\n"),
              AllOf(HasSubstr("line 1, column 1"), HasSubstr("the frequencies are in a row; exchange rows and columns")));
}

TEST_F(CsvRowsAbove, UnitsOfRotations) {
  const auto table = [](const std::string& frf, const std::string& unit) {
    return "Frequency [Hz]\t" + frf + " re [" + unit + "]\t" + frf + " im [" + unit + "]\n" + numbers;
  };
  EXPECT_THAT(error(table("1:+RZ/1:+Z", "m/s^2/N"), OpenOptions{}),
              AllOf(HasSubstr("line 1, column 2"), HasSubstr("'m/s^2/N' is not one of 1:+RZ/1:+Z, a rotation over a force"),
                    HasSubstr("write rad/s^2/N")));
  EXPECT_THAT(error(table("1:+Z/1:+RZ", "m/s^2/N"), OpenOptions{}), HasSubstr("a translation over a moment; write m/s^2/(N*m)"));
  const FrfSet turns = load(*open(write_file("b.csv", table("1:+RZ/1:+Z", "rad/s^2/N")), {}));
  const FrfSet degrees = load(*open(write_file("c.csv", table("1:+RZ/1:+Z", "deg/s^2/N")), {}));
  EXPECT_NEAR(std::abs(degrees.values[0] / turns.values[0]), std::numbers::pi / 180.0, 1e-12);
}

}  // namespace
}  // namespace jointid::frf
