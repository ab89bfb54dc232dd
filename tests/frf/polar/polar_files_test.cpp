// Files whose two numbers of a line are magnitude and phase: read where names say so, refused where they say otherwise.
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "frf/file/file_format.hpp"
#include "tests/frf/file_fixture.hpp"
#include "tests/frf/uff_samples.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Receptances of 2 kg at 50 Hz, 2 % damping, on 91 lines from 10 to 100 Hz.
class PolarFiles : public FileTest {
 protected:
  static constexpr int lines = 91;
  static double hz(int line) { return 10.0 + line; }
  static Complex receptance(int line) {
    const double w = 2.0 * std::numbers::pi * hz(line), own = 100.0 * std::numbers::pi;
    return 0.5 / Complex(own * own - w * w, 0.04 * own * w);
  }
  static double magnitude(int line) { return std::abs(receptance(line)); }
  static double phase(int line, double half_turn) { return std::arg(receptance(line)) / std::numbers::pi * half_turn; }
  static OpenOptions given() {
    OpenOptions options;
    options.response = options.reference = dofs({"1:+Z"});
    options.quantity = Quantity::receptance;
    return options;
  }

  /// Dataset 58 whose complex ordinates are (first, second).
  template <class First, class Second>
  std::string uff(First first, Second second) const {
    samples::Record record;
    record.points = lines;
    for (int line = 0; line < lines; ++line)
      record.data += samples::format("%20.12E%20.12E", first(line), second(line)) + (line % 2 == 1 ? "\n" : "");
    record.data += "\n";
    return record.str();
  }
  template <class First, class Second>
  static std::string csv(const std::string& titles, First first, Second second) {
    std::string text = titles + "\n";
    for (int line = 0; line < lines; ++line) text += samples::format("%g,%.12g,%.12g\n", hz(line), first(line), second(line));
    return text;
  }
  /// As GNU Octave saves it.
  template <class Value>
  static std::string array(const std::string& name, Value value) {
    std::string text = "# name: " + name + "\n# type: matrix\n# rows: " + std::to_string(lines) + "\n# columns: 1\n";
    for (int line = 0; line < lines; ++line) text += samples::format(" %.12g\n", value(line));
    return text + "\n\n";
  }
  static std::string axis() { return array("f", hz); }
  static std::string text(const std::string& name, const std::string& value) {
    return "# name: " + name + "\n# type: string\n# elements: 1\n# length: " + std::to_string(value.size()) + "\n" + value + "\n\n\n";
  }

  FrfSet read(const std::string& name, const std::string& content) const { return load(*open(write_file(name, content), given())); }
  std::string error(const std::string& name, const std::string& content) const {
    return message_of([&] { load(*open(write_file(name, content), given())); });
  }
  void expect_right(const FrfSet& set, const std::string& what) const {
    ASSERT_EQ(set.values.size(), static_cast<std::size_t>(lines)) << what;
    for (int line = 0; line < lines; ++line)
      EXPECT_LE(std::abs(set.values[static_cast<std::size_t>(line)] - receptance(line)), 1e-9 * magnitude(line)) << what;
  }

  static double re(int line) { return receptance(line).real(); }
  static double im(int line) { return receptance(line).imag(); }
  static double degrees(int line) { return phase(line, 180.0); }
  static double radians(int line) { return phase(line, std::numbers::pi); }
  static double tiny(int) { return -1e-3; }
};

TEST_F(PolarFiles, UniversalFilesAreRefusedWithRecordAndRemedy) {
  expect_right(read("a.uff", uff(re, im)), "parts");
  for (const auto& phases : {degrees, radians}) {
    EXPECT_THAT(error("a.uff", uff(magnitude, phases)),
                AllOf(HasSubstr("dataset 58 number 1"), HasSubstr("are no real and imaginary part but magnitudes and phases"),
                      HasSubstr("magnitude · cos(phase)")));
  }
  EXPECT_THAT(error("a.uff", uff([](int line) { return 20.0 * std::log10(magnitude(line)); }, degrees)), HasSubstr("in degrees"));
}

TEST_F(PolarFiles, TablesAreReadByTheirTitles) {
  expect_right(read("a.csv", csv("frequency_hz,mag,phase_deg", magnitude, degrees)), "deg");
  expect_right(read("a.csv", csv("Frequency [Hz],Magnitude [m/N],Phase", magnitude, degrees)), "by numbers");
  expect_right(read("a.csv", csv("Frequency [Hz],Magnitude [m/N],Phase", magnitude, radians)), "radians by numbers");
  EXPECT_THAT(error("a.csv", csv("Frequency [Hz],Magnitude [m/N],Phase", magnitude, tiny)), HasSubstr("degrees or radians"));
  for (const auto& phases : {degrees, radians})
    EXPECT_THAT(error("a.csv", csv("frequency_hz,re,im", magnitude, phases)),
                AllOf(HasSubstr("line 1, column 2"), HasSubstr("but magnitudes and phases"), HasSubstr("name them by what they hold")));
}

TEST_F(PolarFiles, ArraysAreReadByTheirNames) {
  for (const auto& [mag, arg] : std::to_array<std::pair<const char*, const char*>>(
           {{"H_mag", "H_phase_deg"}, {"mag", "phase_deg"}, {"magH", "phaseH_deg"}, {"absH", "angH_deg"}, {"H_abs", "H_arg_deg"},
            {"HMag", "HPhaseDeg"}, {"amplitude", "phasedeg"}, {"magnitude", "phase_degrees"}, {"frfmag", "frfphase_deg"},
            {"H_amp", "H_ph_deg"}, {"H_magnitude", "H_phase_in_deg"}}))
    expect_right(read("a.txt", axis() + array(mag, magnitude) + array(arg, degrees)), arg);
  expect_right(read("a.txt", axis() + array("H_mag", magnitude) + array("H_phase_rad", radians)), "rad");
  expect_right(read("a.txt", axis() + array("H_mag", magnitude) + array("H_phase", degrees)), "by numbers");
  for (const char* name : {"phase_unit", "H_phase_unit", "H_phase_units"}) {
    expect_right(read("a.txt", axis() + array("H_mag", magnitude) + array("H_phase", radians) + text(name, "rad")), name);
    EXPECT_THAT(error("a.txt", axis() + array("H_mag", magnitude) + array("H_phase", radians) + text(name, "gon")),
                AllOf(HasSubstr("variable H_phase"), HasSubstr("'gon' of the phases is not understood")));
  }
  EXPECT_THAT(error("a.txt", axis() + array("H_mag", magnitude) + array("H_phase", tiny)),
              AllOf(HasSubstr("variable H_phase"), HasSubstr("degrees or radians"), HasSubstr("H_phase_deg or H_phase_rad")));
  EXPECT_THAT(error("a.txt", axis() + array("H_mag", magnitude) + array("H_phase_rad", degrees)),
              HasSubstr("in degrees by their numbers and in radians by what is stated"));
  EXPECT_THAT(error("a.txt", axis() + array("H_mag", [](int line) { return 20.0 * std::log10(magnitude(line)); }) +
                                 array("H_phase_deg", degrees)),
              AllOf(HasSubstr("variable H_mag"), HasSubstr("is below 0"), HasSubstr("decibels")));
}

TEST_F(PolarFiles, ArraysOfNeutralNamesAreRefused) {
  EXPECT_THAT(error("a.txt", axis() + array("H_re", magnitude) + array("H_im", degrees)),
              AllOf(HasSubstr("variable H"), HasSubstr("but magnitudes and phases"), HasSubstr("H_mag and H_phase_deg")));
  expect_right(read("a.txt", axis() + array("H_re", re) + array("H_im", im)), "parts");
  EXPECT_THAT(error("a.txt", axis() + array("A", magnitude) + array("B", degrees)), HasSubstr("no complex array"));
}

}  // namespace
}  // namespace jointid::frf
