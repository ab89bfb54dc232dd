// Names by which other programs store frequencies, parts of FRFs and what the numbers are, in files of named arrays.
#include <gmock/gmock.h>

#include <numbers>

#include "frf/file/file_format.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// Files as GNU Octave's `save -text` writes them: 2 − 1i and 3 + 4i at 10 and 20.
class WordsOfArrays : public FileTest {
 protected:
  static std::string range(const std::string& name) {
    return "# name: " + name + "\n# type: range\n# base, limit, increment\n10 20 10\n\n\n";
  }
  static std::string frf(const std::string& name) {
    return "# name: " + name + "\n# type: complex matrix\n# rows: 2\n# columns: 1\n (2,-1)\n (3,4)\n\n\n";
  }
  static std::string real(const std::string& name, const std::string& first, const std::string& second) {
    return "# name: " + name + "\n# type: matrix\n# rows: 2\n# columns: 1\n " + first + "\n " + second + "\n\n\n";
  }
  static std::string text(const std::string& name, const std::string& value) {
    return "# name: " + name + "\n# type: string\n# elements: 1\n# length: " + std::to_string(value.size()) + "\n" + value + "\n\n\n";
  }
  static OpenOptions at_one_dof(std::optional<Quantity> quantity = Quantity::receptance) {
    OpenOptions given;
    given.response = given.reference = dofs({"1:+Z"});
    given.quantity = quantity;
    return given;
  }
  FrfSet read(const std::string& content, const OpenOptions& options = at_one_dof()) const {
    return load(*open(write_file("a.txt", content), options));
  }
  std::string error(const std::string& content, const OpenOptions& options = at_one_dof()) const {
    return message_of([&] { open(write_file("a.txt", content), options); });
  }
};

TEST_F(WordsOfArrays, ForFrequencies) {
  constexpr double turns = 0.5 / std::numbers::pi;
  for (const auto& [name, hz] : std::to_array<std::pair<const char*, double>>(
           {{"fHz", 10.0}, {"f_Hz", 10.0}, {"F_HZ", 10.0}, {"freqHz", 10.0}, {"FreqVec", 10.0}, {"faxis", 10.0}, {"Frequenz", 10.0},
            {"frecuencia", 10.0}, {"fkHz", 1e4}, {"freq_khz", 1e4}, {"freq_rad_s", 10.0 * turns}, {"w_rad", 10.0 * turns},
            {"omega_rad_s", 10.0 * turns}, {"freq_rpm", 10.0 / 60.0}, {"w", 10.0 * turns}, {"omega", 10.0 * turns}}))
    EXPECT_NEAR(read(range(name) + frf("H")).header.frequency_hz[0], hz, 1e-12 * hz) << name;
  for (const char* name : {"fn", "freq_index", "freq_no", "wvec", "W", "F", "Fvec", "F_data", "forces", "fHz2", "omegas"})
    EXPECT_THAT(error(range(name) + frf("H")), AllOf(HasSubstr("has no vector of frequencies"), HasSubstr(name))) << name;
  EXPECT_THAT(error(range("f_Hz") + range("freq_khz") + frf("H")), HasSubstr("has no vector of frequencies"));
}

TEST_F(WordsOfArrays, ForRealAndImaginaryParts) {
  for (const auto& [re, im] : std::to_array<std::pair<const char*, const char*>>(
           {{"H_r", "H_i"}, {"H_R", "H_I"}, {"ReH", "ImH"}, {"re_H", "im_H"}, {"real_FRF", "imag_FRF"}, {"Hr", "Hi"}, {"FRFr", "FRFi"}})) {
    const FrfSet set = read(range("f") + real(re, "2", "3") + real(im, "-1", "4"));
    EXPECT_EQ(set.values, (std::vector<Complex>{{2.0, -1.0}, {3.0, 4.0}})) << re;
  }
  for (const auto& [re, im] : std::to_array<std::pair<const char*, const char*>>(
           {{"H_r", "G_i"}, {"sensor", "sensoi"}, {"magnitude_G", "phase_H"}, {"ReH", "ImG"}}))
    EXPECT_THAT(error(range("f") + real(re, "2", "3") + real(im, "-1", "4")), HasSubstr("no complex array")) << re;
  EXPECT_THAT(error(range("f") + real("H_abs", "2", "3") + real("H_phase", "-1", "4")),
              HasSubstr("does not state whether the phases are in degrees or radians"));
}

TEST_F(WordsOfArrays, ForQuantities) {
  EXPECT_EQ(read(range("f") + frf("accelerance"), at_one_dof(std::nullopt)).header.quantity, Quantity::accelerance);
  EXPECT_EQ(read(range("f") + frf("Y_mobility"), at_one_dof(std::nullopt)).header.quantity, Quantity::mobility);
  EXPECT_THAT(error(range("f") + frf("H"), at_one_dof(std::nullopt)), HasSubstr("does not state which quantity"));
  for (const char* unit : {"N/m", "V/N", "kg", "g^2/Hz"})
    EXPECT_THAT(error(range("f") + frf("H") + text("unit", unit), at_one_dof(std::nullopt)),
                AllOf(HasSubstr("variable unit"), HasSubstr(unit), HasSubstr("is no unit of motion over force")))
        << unit;
}

TEST_F(WordsOfArrays, ForFunctionsOfOtherTypes) {
  const auto typed = [](double type) { return "# name: func_type\n# type: scalar\n" + std::to_string(type) + "\n\n\n"; };
  EXPECT_EQ(read(range("f") + frf("H") + typed(4.0)).values.size(), 2U);
  for (const double type : {2.0, 3.0, 5.0, 6.0})
    EXPECT_THAT(error(range("f") + frf("H") + typed(type)), AllOf(HasSubstr("variable func_type"), HasSubstr("an FRF is of type 4")));
}

TEST_F(WordsOfArrays, OneUnitForAll) {
  const auto cell = [](const std::string& first, const std::string& second) {
    std::string out = "# name: units\n# type: cell\n# rows: 2\n# columns: 1\n";
    for (const std::string& each : {first, second})
      out += "# name: <cell-element>\n# type: string\n# elements: 1\n# length: " + std::to_string(each.size()) + "\n" + each + "\n\n\n";
    return out + "\n\n\n";
  };
  EXPECT_EQ(read(range("f") + frf("H") + cell("mm/N", "mm/N")).values[0], Complex(2e-3, -1e-3));
  EXPECT_THAT(error(range("f") + frf("H") + cell("mm/N", "m/N")), AllOf(HasSubstr("variable units"), HasSubstr("'mm/N' and 'm/N'")));
}

TEST_F(WordsOfArrays, AnArrayWhoseNameTurnsItsAxes) {
  std::string three = range("f") + "# name: H_in_out\n# type: complex matrix\n# ndims: 3\n 2 2 2\n";
  for (int k = 0; k < 8; ++k) three += " (" + std::to_string(k) + ",1)\n";
  OpenOptions given = at_one_dof();
  given.response = dofs({"1:+Z", "2:+Z"}), given.reference = dofs({"1:+Z", "3:+Z"});
  EXPECT_THAT(error(three + "\n\n", given), HasSubstr("names references before responses"));
  const FrfSet set = read(three + "\n\n" + text("axes", "FCR"), given);
  EXPECT_EQ(set.values[set.index(0, 1, 0)].real(), 4.0);
}

TEST_F(WordsOfArrays, ForUnitsOfPlots) {
  for (const auto& [x, y] : std::to_array<std::pair<const char*, const char*>>(
           {{"xunit", "yunit"}, {"x_unit", "y_unit"}, {"XUnit", "YUnit"}, {"xUnits", "yUnits"}, {"abscissa_unit", "ordinate_unit"}})) {
    const FrfSet set = read(range("f") + frf("H") + text(x, "kHz") + text(y, "mm/N"), at_one_dof({}));
    EXPECT_NEAR(set.header.frequency_hz[0], 1e4, 1e-8) << x;
    EXPECT_NEAR(set.values[0].real(), 2e-3, 1e-15) << y;
  }
  EXPECT_THAT(error(range("f") + frf("H") + text("unit", "mm/N") + text("yunit", "m/N")), HasSubstr("another unit is 'mm/N'"));
}

}  // namespace
}  // namespace jointid::frf
