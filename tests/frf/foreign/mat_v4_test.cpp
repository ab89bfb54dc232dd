// Files of MATLAB v4, whose bytes the format describes: a header of five integers, the name, the numbers column by column.
#include <gmock/gmock.h>

#include <cstring>

#include "frf/file/columns.hpp"
#include "frf/file/file_format.hpp"
#include "tests/frf/file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class MatV4File : public FileTest {
 protected:
  template <class Number>
  static std::string bytes(Number number, bool big) {
    std::string out(sizeof number, '\0');
    std::memcpy(out.data(), &number, sizeof number);
    if (big) std::ranges::reverse(out);
    return out;
  }
  template <class Number>
  static std::string variable(const std::string& name, std::int32_t type, std::int32_t rows, std::int32_t columns,
                              const std::vector<double>& numbers, bool complex = false, bool big = false) {
    std::string out;
    for (const std::int32_t field :
         {type + (big ? 1000 : 0), rows, columns, complex ? 1 : 0, static_cast<std::int32_t>(name.size() + 1)})
      out += bytes(field, big);
    out += name + '\0';
    for (const double number : numbers) out += bytes(static_cast<Number>(number), big);
    return out;
  }
  static std::string text(const std::string& name, const std::string& value) {
    const std::vector<double> letters(value.begin(), value.end());
    return variable<double>(name, 1, 1, static_cast<std::int32_t>(value.size()), letters);
  }
  static OpenOptions at(const std::vector<std::string>& response) {
    OpenOptions given;
    given.response = dofs(response), given.reference = dofs({"1:+Z"});
    return given;
  }
};

TEST_F(MatV4File, FrfsOfEveryTypeAndByteOrder) {
  const std::vector<double> numbers = {
      2, 3, 5, 6, -1, 4, 7, 8};  // two responses at two lines: real parts, then imaginary ones; axes stated, as both are two
  for (const bool big : {false, true}) {
    const std::string frequency = variable<std::int16_t>("f", 30, 2, 1, {10, 20}, false, big);
    for (const bool single : {false, true}) {
      const std::string frf =
          single ? variable<float>("H", 10, 2, 2, numbers, true, big) : variable<double>("H", 0, 2, 2, numbers, true, big);
      const auto path = write_file("a.mat", frequency + frf + text("unit", "mm/N") + text("axes", "FRC"));
      EXPECT_EQ(name(detect_format(path)), "MATLAB v4 to v7");
      const FrfSet set = load(*open(path, at({"1:+Z", "2:+Z"})));
      EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 20.0}));
      EXPECT_NEAR(std::abs(set.values[set.index(0, 0, 0)] - Complex(2e-3, -1e-3)), 0.0, 1e-15);
      EXPECT_NEAR(std::abs(set.values[set.index(1, 1, 0)] - Complex(6e-3, 8e-3)), 0.0, 1e-15);
    }
  }
  EXPECT_EQ(read_columns(write_file("b.mat", variable<double>("force", 0, 3, 1, {1, 2, 3}))).columns[0].values,
            (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST_F(MatV4File, CutOffOrDamaged) {
  const std::string whole = variable<double>("f", 0, 2, 1, {10, 20}) + variable<double>("H", 0, 2, 1, {2, 3, -1, 4}, true);
  EXPECT_THAT(message_of([&] { open(write_file("a.mat", whole.substr(0, whole.size() - 1)), at({"1:+Z"})); }),
              AllOf(HasSubstr("variable H"), HasSubstr("is 2 by 1, and the file ends before that")));
  EXPECT_THAT(message_of([&] { open(write_file("a.mat", whole + "more"), at({"1:+Z"})); }),
              HasSubstr("has no header of a MATLAB v4 variable at byte " + std::to_string(whole.size())));
  EXPECT_THAT(
      message_of([&] { open(write_file("a.mat", variable<double>("H", 0, 2'000'000'000, 2'000'000'000, {})), at({"1:+Z"})); }),
      HasSubstr("no FRF file"));
  EXPECT_THAT(
      message_of([&] { open(write_file("a.mat", variable<double>("H", 0, 900'000'000, 900'000'000, {})), at({"1:+Z"})); }),
      HasSubstr("ends before that"));
}

/// The second of one name is read in place of the first, or the first with the size of the second.
TEST_F(MatV4File, TwoVariablesOfOneName) {
  const auto force = [](const std::vector<double>& numbers) {
    return variable<double>("force", 0, static_cast<std::int32_t>(numbers.size()), 1, numbers);
  };
  for (const std::string& content : {force({1, 2, 3}) + force({4, 5, 6}), force({}) + force({1, 2, 3})}) {
    EXPECT_THAT(message_of([&] { read_columns(write_file("a.mat", content)); }),
                AllOf(HasSubstr("variable force"), HasSubstr("is there twice"), HasSubstr("a name of its own")));
  }
}

TEST_F(MatV4File, FormatsThatAreNotReadAreNamed) {
  using namespace std::string_literals;
  const auto error = [&](const std::string& content) { return message_of([&] { open(write_file("a.x", content), {}); }); };
  EXPECT_THAT(error("CDF\1\0\0\0\0"s), AllOf(HasSubstr("is a NetCDF-3 file, which is not read"), HasSubstr("nccopy -k nc4")));
  EXPECT_THAT(error("$TITLE   = RIG\n$ACCELERATION\n$REAL-IMAGINARY OUTPUT\n"),
              AllOf(HasSubstr("that Nastran punched"), HasSubstr("UFF 58")));
  EXPECT_THAT(error("TDSm\x0e\0\0\0"s), HasSubstr("is a TDMS file"));
}

}  // namespace
}  // namespace jointid::frf
