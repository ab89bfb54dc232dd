// Units of axes beside their columns, factors of dataset 164 that are parted by blanks.
#include <gmock/gmock.h>

#include "frf/set/frf_source.hpp"
#include "tests/frf/file_fixture.hpp"
#include "tests/frf/uff_samples.hpp"

namespace jointid::frf {
namespace {

using namespace samples;

/// The first value of a record whose record 10 is `line`, over that of one in newtons.
double over_newton(const std::string& line) {
  std::string record = simple_record().str();
  std::size_t begin = record.find("\n        13 ") + 1;
  record.replace(begin, record.find('\n', begin) - begin, line);
  const TemporaryUff file(record), newton(simple_record().str());
  return load(*open(file.path())).values[0].real() / load(*open(newton.path())).values[0].real();
}

TEST(UffFields, UnitsAFewColumnsToTheLeftOrRight) {
  const std::string types = "        13    0    0    0", name = " NONE";
  EXPECT_DOUBLE_EQ(over_newton(types + name + std::string(17, ' ') + "kN"), 1e-3);
  EXPECT_DOUBLE_EQ(over_newton(types + name + std::string(16, ' ') + "kN"), 1e-3);
  EXPECT_DOUBLE_EQ(over_newton(types + name + std::string(15, ' ') + "daN"), 0.1);
  EXPECT_DOUBLE_EQ(over_newton(types + name + std::string(14, ' ') + "daN"), 0.1);
  EXPECT_NEAR(over_newton(types + name + std::string(35, ' ') + "lbf"), 1.0 / 4.4482216152605, 1e-12);
  EXPECT_DOUBLE_EQ(over_newton(types + " Load cell no. 12345 kN"), 1e-3);
  EXPECT_DOUBLE_EQ(over_newton(types + " Load cell no. 1234567kN"), 1e-3);  // a name of 21 letters
}

TEST(UffFields, FactorsPartedByBlanks) {
  const std::string units =
      "    -1\n   164\n         9mm                           2\n  1.0D+03  1.0D+00  1.0D+00  2.7315D+02\n    -1\n";
  const TemporaryUff file(units + simple_record().str()), metres(simple_record().str());
  EXPECT_DOUBLE_EQ(load(*open(file.path())).values[0].real(), 1e-3 * load(*open(metres.path())).values[0].real());
}

/// A name of 20 letters leaves no blank before the unit: a unit that only begins one column to the left is there; where both may
/// be, or it is the last letter of the name, nobody knows.
TEST(UffFields, UnitsGluedToANameThatFillsItsField) {
  const std::string types = "        13    0    0    0 ";
  EXPECT_NEAR(over_newton(types + "ExcitationForceInputlbf"), 1.0 / 4.4482216152605, 1e-12);
  EXPECT_DOUBLE_EQ(over_newton(types + "ExcitationForceInputdaN"), 0.1);
  EXPECT_DOUBLE_EQ(over_newton(types + "ExcitationForceInputskN"), 1e-3);
  for (const char* glued : {"ExcitationForceInputN", "ExcitationForceInputkN"})
    EXPECT_THROW(over_newton(types + glued), InputError) << glued;
}

TEST(UffFields, QuotesAroundUnits) {
  Record quoted = simple_record();
  quoted.numerator_unit = "\"mm\"", quoted.denominator_unit = "\"N\"";
  const TemporaryUff file(quoted.str()), metres(simple_record().str());
  EXPECT_DOUBLE_EQ(load(*open(file.path())).values[0].real(), 1e-3 * load(*open(metres.path())).values[0].real());
}

/// Where the field of units is blank.
TEST(UffFields, AnAxisThatIsAngularByItsName) {
  const auto first_hz = [](const std::string& name) {
    std::string record = simple_record().str();
    const std::size_t begin = record.find("\n        18 ") + 1;
    record.replace(begin, record.find('\n', begin) - begin, "        18    0    0    0 " + name);
    const TemporaryUff file(record);
    return open(file.path())->header().frequency_hz[0];
  };
  const double turns = first_hz("Frequency") / 6.283185307179586;
  for (const char* name : {"Omega", "Angular frequency", "Kreisfrequenz", "w", "Circular Frequency"})
    EXPECT_NEAR(first_hz(name), turns, 1e-12) << name;
  EXPECT_NEAR(first_hz("Omega                Hz"), 6.283185307179586 * turns, 1e-12);
}

/// Where the numbers allow it, and not where first numbers of both signs show that it is only the label of a plot.
TEST(UffFields, ALabelOfMagnitudesAndPhases) {
  const auto error = [](const std::string& id, const char* data) -> std::string {
    Record record = simple_record();
    record.id = id, record.data = data, record.data_type = 5;
    const TemporaryUff file(record.str());
    try {
      open(file.path());
    } catch (const InputError& found) {
      return found.what();
    }
    return {};
  };
  const char* const positive = "  1.00000E-03 -2.00000E+00  2.00000E-03 -9.00000E+01  1.00000E-03 -1.78000E+02\n";
  const char* const both = " -1.00000E-03 -2.00000E+00  2.00000E-03 -9.00000E+01  1.00000E-03 -1.78000E+02\n";
  for (const char* label : {"FRF Mag/Phase", "Magnitude & Phase", "Amplitude, phase [deg]", "Betrag/Phase"}) {
    EXPECT_THAT(error(label, positive), ::testing::HasSubstr("names magnitudes and phases, and no first number of a line is"))
        << label;
    EXPECT_EQ(error(label, both), "") << label;
  }
  for (const char* label : {"Real/Imag", "Magnetic base, phase 2 of the test", "Phase reference: sensor 3"})
    EXPECT_EQ(error(label, positive), "") << label;
}

TEST(UffFields, UnitsOfRotations) {
  Record turning = simple_record();
  turning.response_direction = 4, turning.numerator_type = 12, turning.numerator_unit = "m/s^2";
  const TemporaryUff file(turning.str());
  try {
    open(file.path());
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                ::testing::HasSubstr("unit 'm/s^2' is not one of a rotation, its velocity or acceleration (1:+RX)"));
  }
  OpenOptions given;
  given.unit = "m/(s^2*N)";
  turning.numerator_unit = "rad/s^2";
  const TemporaryUff right(turning.str());
  EXPECT_EQ(load(*open(file.path(), given)).values, load(*open(right.path())).values);
}

std::vector<std::string> doubts_of(const std::string& record) {
  const TemporaryUff file(record);
  return open(file.path())->header().doubts;
}

/// What a header states in words against its own fields is a note.
TEST(UffFields, WordsAgainstTheFieldsAreNotes) {
  const auto identified = [](const std::string& id) {
    Record record = simple_record();
    record.id = id, record.numerator_unit = "m", record.denominator_unit = "N";
    return doubts_of(record.str());
  };
  using testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;
  EXPECT_THAT(identified("Units: mm/N"),
              ElementsAre(HasSubstr("dataset 58 number 1: an identification line states 'Units: mm/N'")));
  EXPECT_THAT(identified("scale factor 9.81"),
              ElementsAre(HasSubstr("'scale factor 9.81', and the numbers are taken as they are")));
  Record unitless = simple_record();
  unitless.id = "Sensitivity 100 mV/g";
  EXPECT_THAT(doubts_of(unitless.str()), ElementsAre(HasSubstr("Sensitivity 100 mV/g")));
  for (const char* plain : {"Units: m/N", "Sensitivity 100 mV/g", "plate, run 3", "Calibration date 12.3.2026"})
    EXPECT_THAT(identified(plain), IsEmpty()) << plain;
  const auto named = [](const std::string& name) {
    std::string record = simple_record().str();
    const std::size_t begin = record.find("\n         8 ") + 1;
    return doubts_of(record.replace(begin, record.find('\n', begin) - begin, "         8    0    0    0 " + name));
  };
  EXPECT_THAT(named("Displacement (mm)    m"),
              ElementsAre(HasSubstr("record 9 names the axis 'Displacement (mm)', and its unit is 'm'")));
  EXPECT_THAT(named("Force                NONE"), ElementsAre(HasSubstr("its type is of another kind")));
  EXPECT_THAT(named("Displacement (mm)    mm"), IsEmpty());
}

/// 1 km is no unit of a structure: the factor is the other way round. Before, FRFs were off by a million.
TEST(UffFields, AFactorOfLengthTheOtherWayRoundIsAnError) {
  const std::string units =
      "    -1\n   164\n         9mm                           2\n  1.0D-03  1.0D+00  1.0D+00  2.7315D+02\n    -1\n";
  const TemporaryUff file(units + simple_record().str());
  EXPECT_THAT(message_of([&] { open(file.path()); }), testing::HasSubstr("the factor of length 0.001, a unit of 1000 m"));
}

}  // namespace
}  // namespace jointid::frf
