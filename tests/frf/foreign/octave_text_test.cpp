// Files that GNU Octave writes by "save -text", and the labels of arrays that scripts beside them use.
#include <gmock/gmock.h>

#include <numbers>

#include "frf/file/file_format.hpp"
#include "frf/mat/octave_text.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double g_of_si = 9.80665;

class OctaveText : public FileTest {
 protected:
  FrfSet read(const std::string& content, const OpenOptions& options = {}) const {
    try {
      return load(*open(write_file("a.txt", content), options));
    } catch (const InputError& error) {
      ADD_FAILURE() << error.what() << "\n" << content;
      return {};
    }
  }
  std::string error(const std::string& content, const OpenOptions& options = {}) const {
    return message_of([&] { open(write_file("a.txt", content), options); });
  }
};

const std::string head = "# Created by Octave 8.4.0, Mon Jan 01 00:00:00 2024 UTC <a@b>\n";
const std::string f_range = "# name: f\n# type: range\n# base, limit, increment\n10 20 10\n\n\n";
const std::string column = "# type: complex matrix\n# rows: 2\n# columns: 1\n (2,-1)\n (3,4)\n\n\n";

std::string text(const std::string& name, const std::string& value) {
  return "# name: " + name + "\n# type: string\n# elements: 1\n# length: " + std::to_string(value.size()) + "\n" + value + "\n\n\n";
}

std::string scalar(const std::string& name, double value) {
  return "# name: " + name + "\n# type: scalar\n" + std::to_string(value) + "\n\n\n";
}

std::string structure(const std::string& name, const std::vector<std::string>& fields) {
  std::string all = "# name: " + name + "\n# type: scalar struct\n# ndims: 2\n 1 1\n# length: " + std::to_string(fields.size()) + "\n";
  for (const std::string& field : fields) all += field;
  return all + "\n\n";
}

OpenOptions at_one_point() {
  OpenOptions options;
  options.response = options.reference = dofs({"1:+Z"});
  options.quantity = Quantity::accelerance;
  return options;
}

/// 2 − 1i and 3 + 4i in `unit` at 10 and 20 Hz.
void expect_column(const FrfSet& set, double unit) {
  ASSERT_EQ(set.values.size(), 2U);
  const std::array<Complex, 2> right = {Complex(2.0, -1.0), Complex(3.0, 4.0)};
  for (std::size_t l = 0; l < 2; ++l) {
    const double omega = 20.0 * std::numbers::pi * static_cast<double>(l + 1);
    EXPECT_TRUE(near(set.values[l], -unit * right[l] / (omega * omega), 1e-12)) << set.values[l];
  }
}

TEST_F(OctaveText, FrfsWithTheirAxisAndUnit) {
  expect_column(read(head + "# name: H\n" + column + f_range, at_one_point()), 1.0);
  expect_column(read(head + "# name: H\n" + column + f_range + text("unit", "g/N"), at_one_point()), g_of_si);
  expect_column(read(head + structure("run", {"# name: H\n" + column, f_range, text("units", "g/N")}), at_one_point()), g_of_si);
  std::string windows = head + "# name: H\n" + column + f_range;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) windows.replace(at, 1, "\r\n");
  expect_column(read(windows, at_one_point()), 1.0);
  EXPECT_EQ(detect_format(write_file("b.txt", head + f_range)), FileFormat::octave_text);
}

TEST_F(OctaveText, ArraysAndCellsOfDofs) {
  const std::string frf = "# name: frf\n# type: complex matrix\n# ndims: 3\n 2 2 1\n (1,0)\n (2,0)\n (3,0)\n (4,0)\n\n\n";
  const std::string cell = "# name: response_dof\n# type: cell\n# rows: 2\n# columns: 1\n" + text("<cell-element>", "7:+Z") +
                           text("<cell-element>", "5:-X") + "\n\n";
  OpenOptions options;
  options.reference = dofs({"7:+Z"}), options.quantity = Quantity::receptance;
  const FrfSet set = read(head + frf + f_range + cell + text("axes", "FRC"), options);  // [line, response, reference]
  ASSERT_EQ(set.header.response, dofs({"7:+Z", "5:-X"}));
  EXPECT_EQ(set.values, (std::vector<Complex>{1.0, 3.0, 2.0, 4.0}));
}

TEST_F(OctaveText, DamageIsNamed) {
  const std::string whole = head + f_range + "# name: H\n" + column;
  EXPECT_THAT(error(whole.substr(0, whole.find("(3,4)")), at_one_point()),
              AllOf(HasSubstr("variable H: a line has 0 numbers, not 1"), HasSubstr("save it again")));
  EXPECT_THAT(error(head + "# name: H\n" + column, at_one_point()), HasSubstr("has no vector of frequencies; its variables are H [2x1]"));
  EXPECT_THAT(error(head + f_range + "# name: H\n# type: complex matrix\n# rows: 99999999999\n# columns: 1\n (1,2)\n", at_one_point()),
              HasSubstr("'99999999999' is no size"));
  EXPECT_THAT(error(head + f_range + "# name: H\n# type: complex matrix\n# rows: 1\n# columns: 1\n (1;2)\n", at_one_point()),
              HasSubstr("'(1;2)' is not a number"));
}

TEST_F(OctaveText, LabelsOfPyuffAreUnits) {
  const std::vector<std::string> types = {scalar("ordinate_spec_data_type", 12), scalar("orddenom_spec_data_type", 13)};
  const std::string x = "# name: x\n# type: matrix\n# rows: 2\n# columns: 1\n 600\n 1200\n\n\n";
  const auto dataset = [&](const std::string& motion, const std::string& force) {
    return head + structure("d", {"# name: data\n" + column, x, text("abscissa_axis_units_lab", "rpm"), types[0], types[1],
                                  text("ordinate_axis_units_lab", motion), text("orddenom_axis_units_lab", force)});
  };
  OpenOptions options = at_one_point();
  options.quantity.reset();
  expect_column(read(dataset("g", "N"), options), g_of_si);
  expect_column(read(dataset("NONE", "NONE"), options), 1.0);
  expect_column(read(dataset("g", "lbf"), options), g_of_si / 4.4482216152605);
  expect_column(read(dataset("NONE", "kN"), options), 1e-3);
  EXPECT_THAT(error(dataset("V", "N"), options), HasSubstr("unknown unit '(V)/(N)'"));
}

TEST_F(OctaveText, NamesAndTextsThatContradictAreRefused) {
  const std::string plain = head + "# name: H\n" + column + f_range;
  for (const char* name : {"frf_conj", "impedance", "dynamic_stiffness", "H_inv"}) {
    EXPECT_THAT(error(head + "# name: " + name + "\n" + column + f_range, at_one_point()),
                AllOf(HasSubstr("is no FRF of motion over force by its name"), HasSubstr("--variable")));
    OpenOptions named = at_one_point();
    named.variable = name;
    expect_column(read(head + "# name: " + name + "\n" + column + f_range, named), 1.0);
  }
  EXPECT_THAT(error(plain + text("label", "Accelerance (g/N)"), at_one_point()), HasSubstr("states the unit '(g/N)'"));
  EXPECT_THAT(error(plain + text("meta", "unit: g/N"), at_one_point()), HasSubstr("states the unit 'g/N'"));
  EXPECT_THAT(error(plain + structure("meta", {text("acc_unit", "g"), text("force_unit", "N")}), at_one_point()),
              HasSubstr("variable meta.acc_unit: is not read"));
  EXPECT_THAT(error(head + "# name: Z\n" + column + f_range, at_one_point()), HasSubstr("is no FRF of motion over force by its name"));
  EXPECT_THAT(error(plain + text("unitOfFreq", "kHz"), at_one_point()),
              AllOf(HasSubstr("is 'kHz' and is not read"), HasSubstr("did you mean frequency_unit?")));
  const std::string khz = "# name: f\n# type: matrix\n# rows: 2\n# columns: 1\n 0.01\n 0.02\n\n\n";
  expect_column(read(head + "# name: H\n" + column + khz + text("freqUnits", "kHz"), at_one_point()), 1.0);
  expect_column(read(plain + structure("geometry", {text("unit_of_positions", "mm")}), at_one_point()), 1.0);
}

}  // namespace
}  // namespace jointid::frf
