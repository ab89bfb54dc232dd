#include <gmock/gmock.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>

#include "frf/uff/uff_file.hpp"
#include "uff_samples.hpp"

namespace jointid::frf {
namespace {

using namespace samples;
using testing::AllOf;
using testing::HasSubstr;

FrfSet load_text(const std::string& bytes, const OpenOptions& options = {}) {
  const TemporaryUff file(bytes);
  return load(*open_uff(file, options));
}

std::string load_error(const std::string& bytes, const OpenOptions& options = {}) {
  return error_of([&] { load_text(bytes, options); });
}

OpenOptions as(Quantity quantity) {
  OpenOptions options;
  options.quantity = quantity;
  return options;
}

const std::vector<Complex> simple_values = {{1.0, 0.5}, {2.0, 1.0}, {3.0, 1.5}};

TEST(UffRead, ComplexDoubleText) {
  const FrfSet set = load_text(simple_record().str());
  EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 11.0, 12.0}));
  EXPECT_EQ(set.header.response, std::vector<Dof>{Dof::parse("1:+Z")});
  EXPECT_EQ(set.header.quantity, Quantity::receptance);
  EXPECT_EQ(set.values, simple_values);
}

TEST(UffRead, FieldsThatTouch) {
  Record record = simple_record();
  record.data =
      " 1.000000000000E+000-5.000000000000E-001 2.000000000000E+000-1.000000000000E-100\n"
      "-3.000000000000E+000 1.500000000000E+000\n";
  const FrfSet set = load_text(record.str());
  EXPECT_EQ(set.values, (std::vector<Complex>{{1.0, -0.5}, {2.0, -1e-100}, {-3.0, 1.5}}));
}

TEST(UffRead, TouchingNegativeSingles) {
  Record record = simple_record();
  record.data_type = 5;
  record.data = "-1.000000E+00-5.000000E-01-2.000000E+00-1.000000E+00-3.000000E+00-1.500000E+00\n";
  EXPECT_EQ(load_text(record.str()).values, (std::vector<Complex>{{-1.0, -0.5}, {-2.0, -1.0}, {-3.0, -1.5}}));
}

TEST(UffRead, TouchingHeaderFields) {
  Record record = simple_record();
  record.response_node = 9'999'999'999;
  record.reference_node = 1'234'567'890;
  record.response_name = "abcdefghij";
  const FrfSet set = load_text(record.str());
  EXPECT_EQ(set.header.response[0].node, 9'999'999'999);
  EXPECT_EQ(set.header.reference[0].node, 1'234'567'890);
}

TEST(UffRead, FieldsOfOtherWidths) {
  Record record = simple_record();
  record.data_type = 5;
  record.data =
      "  1.0000000E+00  5.0000000E-01  2.0000000E+00  1.0000000E+00  3.0000000E+00  1.5000000E+00\n";
  EXPECT_EQ(load_text(record.str()).values, simple_values);
}

TEST(UffRead, FortranExponents) {
  Record record = simple_record();
  record.data =
      "             1.0D+00             5.0-001             1.0+100            1.0-101\n"
      "              3.D+00             1.5d+00\n";
  EXPECT_EQ(load_text(record.str()).values, (std::vector<Complex>{{1.0, 0.5}, {1e100, 1e-101}, {3.0, 1.5}}));
}

TEST(UffRead, PaddedLastLine) {
  Record record = simple_record();
  record.data.pop_back();
  record.data += "  0.000000000000E+00  0.000000000000E+00   \n\n";
  EXPECT_EQ(load_text(record.str()).values, simple_values);
}

TEST(UffRead, BlankFieldInsideALine) {
  Record record = simple_record();
  record.data =
      "  1.000000000000E+00                      2.000000000000E+00  1.000000000000E+00\n"
      "  3.000000000000E+00  1.500000000000E+00  0.000000000000E+00\n";
  EXPECT_THAT(load_error(record.str()), AllOf(HasSubstr("dataset 58 number 1, data line 1 (byte "),
                                              HasSubstr("not a line of numbers")));
}

TEST(UffRead, MissingValues) {
  Record record = simple_record();
  record.data = record.data.substr(0, record.data.rfind("  1.5")) + "\n";
  EXPECT_THAT(load_error(record.str()), HasSubstr("5 of 6 values were found"));
}

TEST(UffRead, MoreValuesThanDeclared) {
  Record record = simple_record();
  record.data += "  4.000000000000E+00  1.500000000000E+00\n";
  EXPECT_THAT(load_error(record.str()), HasSubstr("more data than the 6 values"));
}

TEST(UffRead, CarriageReturns) {
  std::string text = simple_record().str();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
  EXPECT_EQ(load_text(text).values, simple_values);
}

TEST(UffRead, MissingLastDelimiter) {
  Record record = simple_record();
  record.close.clear();
  EXPECT_EQ(load_text(record.str()).values, simple_values);
  record.data.resize(record.data.size() - 2);  // cut inside the last number, which stays a number
  EXPECT_THAT(load_error(record.str()), HasSubstr("5 of 6 values were found"));
  record.data.resize(record.data.size() - 1);
  EXPECT_THAT(load_error(record.str()), HasSubstr("4 of 6 values were found"));
}

TEST(UffRead, DeclaredPointsAreNotAllocated) {
  Record record = simple_record();
  record.points = 2'147'483'647;
  EXPECT_THAT(load_error(record.str()), HasSubstr("6 of 4294967294 values were found"));
  Record binary = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0});
  binary.points = 2'147'483'647;
  EXPECT_THAT(load_error(binary.str()), HasSubstr("of 4294967294 values were found"));
}

/// So many that the lines are even, and passed over by their length: real and imaginary parts i, −i/2 at line i.
constexpr int many_points = 301;

Record long_record(std::int64_t response_node = 1) {
  Record record;
  record.response_node = response_node;
  record.points = many_points;
  for (int i = 0; i < many_points; ++i) {
    record.data += format("%20.12E%20.12E", double(i), -0.5 * i);
    if (i % 2 == 1 || i + 1 == many_points) record.data += "\n";
  }
  return record;
}

/// The lines of the record's data, each given to change(number, line).
template <class Change>
Record with_lines(Record record, Change change) {
  std::istringstream lines(record.data);
  record.data.clear();
  int number = 0;
  for (std::string line; std::getline(lines, line);) record.data += change(number++, line);
  return record;
}

TEST(UffRead, LongTextOfAnyLineLengths) {
  std::vector<Complex> expected;
  for (int i = 0; i < many_points; ++i) expected.emplace_back(i, -0.5 * i);
  const auto values_of = [](const Record& first) {
    const FrfSet set = load_text(first.str() + long_record(2).str());
    EXPECT_EQ(set.header.response.size(), 2U);
    std::vector<Complex> values;
    for (std::size_t line = 0; line < set.header.lines(); ++line) values.push_back(set.values[2 * line]);
    return values;
  };
  EXPECT_EQ(values_of(long_record()), expected);
  EXPECT_EQ(values_of(with_lines(long_record(), [](int, const std::string& line) { return line + "  \r\n"; })), expected);
  EXPECT_EQ(values_of(with_lines(long_record(), [](int i, const std::string& line) { return line + (i == 70 ? " \n" : "\n"); })),
            expected);
  EXPECT_EQ(values_of(with_lines(long_record(), [](int i, const std::string& line) { return line + (i == 0 ? " \n" : "\n"); })),
            expected);
  EXPECT_EQ(values_of(with_lines(long_record(), [](int i, const std::string& line) { return line + (i == 9 ? "\n\n" : "\n"); })),
            expected);
}

TEST(UffRead, LongTextWithALineTooFewOrTooMany) {
  const auto error = [](int times) {
    const Record first = with_lines(long_record(), [&](int i, const std::string& line) {
      return i == 70 && times == 0 ? "" : line + "\n" + (i == 70 && times == 2 ? line + "\n" : "");
    });
    return load_error(first.str() + long_record(2).str());
  };
  EXPECT_THAT(error(0), AllOf(HasSubstr("dataset 58 number 1"), HasSubstr("598 of 602 values were found")));
  EXPECT_THAT(error(2), AllOf(HasSubstr("dataset 58 number 1, data line 152"), HasSubstr("more data than the 602 values")));
  const Record delimiter =
      with_lines(long_record(), [](int i, const std::string& line) { return i == 70 ? "    -1\n" : line + "\n"; });
  EXPECT_THAT(load_error(delimiter.str()), HasSubstr("is damaged or cut off"));
}

/// A file cut at any byte is read as if whole (nothing but the delimiter is missing) or is an InputError.
TEST(UffRead, CutAtEveryByte) {
  std::string whole = simple_record().str();
  Record binary = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5});
  for (const std::string& bytes : {whole, binary.str()}) {
    int read = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      try {
        EXPECT_EQ(load_text(bytes.substr(0, length)).values, simple_values) << length;
        ++read;
      } catch (const InputError&) {
      }
    }
    EXPECT_GT(read, 0);
    EXPECT_LE(read, 8);
  }
}

/// What FrfSet promises: a value for every line, response and reference, finite or NaN, over an ascending axis.
void expect_consistent(const FrfSet& set) {
  const std::vector<double>& axis = set.header.frequency_hz;
  EXPECT_GT(set.values.size(), 0u);
  EXPECT_EQ(set.values.size(), axis.size() * set.header.response.size() * set.header.reference.size());
  EXPECT_TRUE(set.coherence.empty() || set.coherence.size() == set.values.size());
  EXPECT_TRUE(std::ranges::all_of(axis, [](double hz) { return std::isfinite(hz) && hz >= 0.0; }));
  EXPECT_EQ(std::ranges::adjacent_find(axis, std::greater_equal()), axis.end());
  EXPECT_TRUE(std::ranges::none_of(set.values, [](const Complex& value) { return std::isinf(value.real()) || std::isinf(value.imag()); }));
}

/// Whether a file was read, to a consistent set. If not, the InputError names the file.
bool is_read(const std::filesystem::path& file) {
  try {
    expect_consistent(load(*open_uff(file)));
    return true;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    return false;
  }
}

/// Bits that turn a digit into another, a blank into a digit, and a letter into none of ASCII.
constexpr std::array<unsigned, 3> damages = {0x05, 0x19, 0x80};

/// Every byte of a text and a binary record, one after the other: names and blanks may be anything, what is counted or computed
/// may not.
TEST(UffRead, AnyByteMayBeDamaged) {
  Record binary = binary_record<float>(5, {1.0f, 0.5f, 2.0f, 1.0f, 3.0f, 1.5f});
  binary.response_node = 2;
  const std::string whole = units_164(1.0, 1.0) + simple_record().str() + binary.str();
  const TestFolder folder;
  const auto reads = [&](const std::string& bytes) {
    std::ofstream(folder / "sample.uff", std::ios::binary) << bytes;
    return is_read(folder / "sample.uff");
  };
  ASSERT_TRUE(reads(whole));
  std::size_t read = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    SCOPED_TRACE("byte " + std::to_string(at));
    std::string damaged = whole;
    damaged[at] = static_cast<char>(static_cast<unsigned char>(whole[at]) ^ damages[at % damages.size()]);
    read += reads(damaged);
  }
  EXPECT_GT(read, whole.size() / 4);
  EXPECT_LT(read, 3 * whole.size() / 4);
}

TEST(UffRead, BinaryTypesAndByteOrders) {
  const std::vector<double> complex_doubles = {1.0, 0.5, 2.0, 1.0, 3.0, 1.5};
  const std::vector<float> complex_singles(complex_doubles.begin(), complex_doubles.end());
  for (const bool big : {false, true}) {
    EXPECT_EQ(load_text(binary_record(6, complex_doubles, big).str()).values, simple_values);
    EXPECT_EQ(load_text(binary_record(5, complex_singles, big).str()).values, simple_values);
    for (const Record& record : {binary_record<double>(4, {1.0, 2.0, 3.0}, big), binary_record<float>(2, {1.f, 2.f, 3.f}, big)}) {
      const TemporaryUff file(record.str());
      EXPECT_EQ(read_uff58(file, 0).values, (std::vector<Complex>{1.0, 2.0, 3.0}));
    }
  }
}

TEST(UffRead, UnevenAbscissa) {
  Record record = binary_record<float>(5, {10.f, 1.f, .5f, 11.5f, 2.f, 1.f, 20.f, 3.f, 1.5f});
  record.even = 0;
  FrfSet set = load_text(record.str());
  EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 11.5, 20.0}));
  EXPECT_EQ(set.values, simple_values);

  Record text = simple_record();
  text.even = 0;
  text.data =
      " 1.00000E+01  1.000000000000E+00  5.000000000000E-01\n 1.15000E+01  2.000000000000E+00  "
      "1.000000000000E+00\n"
      " 2.00000E+01  3.000000000000E+00  1.500000000000E+00\n";
  set = load_text(text.str());
  EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 11.5, 20.0}));
  EXPECT_EQ(set.values, simple_values);

  text.data_type = 4;
  text.data =
      "  1.00000E+01  1.000000000000E+00  1.15000E+01  2.000000000000E+00\n  2.00000E+01  "
      "3.000000000000E+00\n";
  const TemporaryUff file(text.str());
  EXPECT_EQ(read_uff58(file, 0).values, (std::vector<Complex>{1.0, 2.0, 3.0}));
}

/// Addendum B of the format makes every abscissa a single; many programs write doubles with doubles.
TEST(UffRead, UnevenDoublesWithSingleOrDoubleAbscissa) {
  Record doubles = binary_record<double>(6, {10.0, 1.0, 0.5, 11.5, 2.0, 1.0, 20.0, 3.0, 1.5});
  doubles.even = 0;
  Record mixed = doubles;
  mixed.data.clear();
  for (int i = 0; i < 3; ++i) {
    mixed.data += bytes_of<float>({std::array{10.f, 11.5f, 20.f}[static_cast<std::size_t>(i)]}) +
                  bytes_of<double>({1.0 + i, 0.5 * (1 + i)});
  }
  for (Record record : {doubles, mixed}) {
    for (const long declared : {static_cast<long>(record.data.size()), 0L}) {
      record.declared_bytes = declared;
      const FrfSet set = load_text(record.str());
      EXPECT_EQ(set.header.frequency_hz, (std::vector<double>{10.0, 11.5, 20.0}));
      EXPECT_EQ(set.values, simple_values);
    }
  }
}

TEST(UffRead, WrongByteCountIsNotBelieved) {
  Record record = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5});
  for (const long declared : {0L, 24L, 1'000'000L}) {
    record.declared_bytes = declared;
    EXPECT_EQ(load_text(record.str()).values, simple_values);
  }
}

TEST(UffRead, LineEndsBeforeTheClosingDelimiter) {
  Record record = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5});
  for (const char* end : {"", "\n", "\r\n"}) {
    record.before_close = end;
    EXPECT_EQ(load_text(record.str()).values, simple_values);
  }
}

TEST(UffRead, DelimiterInsideABinaryPayload) {
  const std::string delimiter = "\n    -1\n    58\n ";
  ASSERT_EQ(delimiter.size(), 16u);
  Record record = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5});
  record.data.replace(16, 16, delimiter);
  const TemporaryUff file(record.str() + simple_record().str());
  EXPECT_EQ(summarize_uff(file).functions.size(), 2u);
  const Uff58 read = read_uff58(file, 0);
  EXPECT_EQ(read.values[0], Complex(1.0, 0.5));
  EXPECT_EQ(read.values[2], Complex(3.0, 1.5));
  EXPECT_EQ(bytes_of<double>({read.values[1].real(), read.values[1].imag()}), delimiter);
}

TEST(UffRead, BinarySizeThatEndsNowhere) {
  Record record = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5, 9.0});
  EXPECT_THAT(load_error(record.str()),
              AllOf(HasSubstr("48 bytes that record 7 implies"), HasSubstr("declares 56")));
}

TEST(UffRead, FloatingPointFormatsNotRead) {
  Record record = binary_record<double>(6, {1.0, 0.5, 2.0, 1.0, 3.0, 1.5});
  record.float_format = 1;
  EXPECT_THAT(load_error(record.str()), HasSubstr("1 (DEC VMS) is not read"));
  record.float_format = 3;
  EXPECT_THAT(load_error(record.str()), HasSubstr("3 (IBM 5/370) is not read"));
  record.float_format = 2;
  record.byte_order = 7;
  EXPECT_THAT(load_error(record.str()), HasSubstr("byte order 7"));
}

TEST(UffRead, OtherDatasetsAreSkipped) {
  std::string other =
      "    -1\n  2414b     1     2           2          20     0     0           0           "
      "0\nfirst\nsecond\n";
  other += std::string("\n    -1\n    58\n 12345", 20) + "\n    -1\n";
  other += "    -1\n  9999\n        -1        -1\nanything at all\n    -1\n";
  const TemporaryUff file(other + simple_record().str());
  EXPECT_EQ(load(*open_uff(file)).values, simple_values);
  const UffSummary summary = summarize_uff(file);
  ASSERT_EQ(summary.datasets.size(), 3u);
  EXPECT_EQ(summary.datasets[0].dataset, "2414b");
  EXPECT_EQ(summary.datasets[1].dataset, "9999");
  EXPECT_EQ(summary.datasets[2].dataset, "58");
  std::string cut = "    -1\n  2414b     1     2           0         999\nabc";
  EXPECT_THAT(load_error(cut), HasSubstr("declares 999 bytes"));
}

TEST(UffRead, NamesInLatin1AndUtf8) {
  for (const std::string& name : {std::string("Tr\xE4ger"), std::string("Tr\xC3\xA4ger")}) {
    Record record = simple_record();
    record.response_name = name + std::string(10 - 6, ' ');  // padded by characters
    record.response_node = 1234567890;
    record.id = name;
    const TemporaryUff file(record.str());
    EXPECT_EQ(open_uff(file)->header().response[0].node, 1234567890);
    EXPECT_EQ(summarize_uff(file).functions[0].id[1], "Tr\xC3\xA4ger");
  }
}

TEST(UffRead, SignsFollowTheFirstAppearance) {
  Record first = simple_record(1.0);
  first.response_direction = -3;
  first.response_node = 2;
  Record second = simple_record(2.0);
  second.response_direction = 3;
  second.response_node = 2;
  second.reference_node = 7;
  second.reference_direction = -1;
  Record third = second;
  third.response_node = 5;
  third.response_direction = 6;
  third.reference_direction = 1;
  const FrfSet set = load_text(first.str() + second.str() + third.str());
  EXPECT_EQ(set.header.response, (std::vector<Dof>{Dof::parse("2:-Z"), Dof::parse("5:+RZ")}));
  EXPECT_EQ(set.header.reference, (std::vector<Dof>{Dof::parse("1:+Z"), Dof::parse("7:-X")}));
  EXPECT_EQ(set.values[set.index(0, 0, 0)], Complex(1.0, 0.5));
  EXPECT_EQ(set.values[set.index(0, 0, 1)], Complex(-2.0, -1.0));
  EXPECT_TRUE(std::isnan(set.values[set.index(0, 1, 0)].real()));  // not measured
  EXPECT_EQ(set.values[set.index(0, 1, 1)], Complex(-2.0, -1.0));
}

TEST(UffRead, DuplicatesNameBothRecords) {
  Record again = simple_record();
  again.response_direction = -3;
  EXPECT_THAT(load_error(simple_record().str() + again.str()),
              AllOf(HasSubstr("dataset 58 number 2, record 6"), HasSubstr("already in dataset 58 number 1")));
}

TEST(UffRead, ScalarDirectionIsNoDof) {
  Record record = simple_record();
  record.reference_direction = 0;
  EXPECT_THAT(load_error(record.str()),
              AllOf(HasSubstr("reference node 1 with direction code 0"),
                    HasSubstr("--reference 1:+X (reference_dofs in a scene)"), HasSubstr("write them there")));
}

TEST(UffRead, AxesAgreeWithinATenthOfALine) {
  Record other = simple_record(2.0);
  other.response_node = 2;
  other.first = 10.09;
  EXPECT_EQ(load_text(simple_record().str() + other.str()).header.frequency_hz[0], 10.0);
  other.first = 10.11;
  EXPECT_THAT(load_error(simple_record().str() + other.str()),
              AllOf(HasSubstr("dataset 58 number 2, frequency axis"), HasSubstr("dataset 58 number 1 has")));
  other.first = 10.0;
  other.points = 2;
  EXPECT_THAT(load_error(simple_record().str() + other.str()),
              AllOf(HasSubstr("2 points"), HasSubstr("dataset 58 number 1 has 3")));
}

TEST(UffRead, UnevenAxesAreComparedWhenRead) {
  Record other = binary_record<float>(5, {10.f, 1.f, .5f, 11.f, 2.f, 1.f, 12.2f, 3.f, 1.5f});
  other.even = 0;
  other.response_node = 2;
  const TemporaryUff file(simple_record().str() + other.str());
  const auto source = open_uff(file);
  const std::vector<std::size_t> lines = {0}, zero = {0}, one = {1};
  std::vector<Complex> value(1);
  source->read({lines, zero, zero}, value);
  for (int i = 0; i < 2; ++i) {
    EXPECT_THAT(error_of([&] {
                  source->read({lines, one, zero}, value);
                }),
                HasSubstr("dataset 58 number 2, frequency axis"));
  }
}

TEST(UffRead, OnlyWhatIsAskedForIsRead) {
  Record damaged = simple_record(5.0);
  damaged.response_node = 2;
  damaged.data.replace(5, 1, "x");
  const TemporaryUff file(damaged.str() + simple_record().str());
  const auto source = open_uff(file);
  const std::vector<std::size_t> lines = {0, 2}, zero = {0}, one = {1};
  std::vector<Complex> values(2);
  source->read({lines, one, zero}, values);
  EXPECT_EQ(values, (std::vector<Complex>{simple_values[0], simple_values[2]}));
  EXPECT_THAT(error_of([&] {
                source->read({lines, zero, zero}, values);
              }),
              HasSubstr("dataset 58 number 1, data line 1 (byte "));
}

TEST(UffRead, MobilityAndAccelerance) {
  Record record = simple_record();
  record.numerator_type = 11;
  FrfSet set = load_text(record.str());
  const double omega = 2.0 * std::numbers::pi * 10.0;
  EXPECT_EQ(set.header.quantity, Quantity::mobility);
  EXPECT_NEAR(std::abs(set.values[0] - Complex(1.0, 0.5) / Complex(0.0, omega)), 0.0, 1e-17);
  record.numerator_type = 12;
  record.first = 0.0;
  record.step = 5.0;
  set = load_text(record.str());
  EXPECT_EQ(set.header.quantity, Quantity::accelerance);
  EXPECT_TRUE(std::isnan(set.values[0].real()));
  EXPECT_NEAR(std::abs(set.values[2] + Complex(3.0, 1.5) / (omega * omega)), 0.0, 1e-17);
}

TEST(UffRead, RecordsOfDifferentQuantities) {
  Record other = simple_record();
  other.response_node = 2;
  other.numerator_type = 12;
  const FrfSet set = load_text(simple_record().str() + other.str());
  const double omega = 2.0 * std::numbers::pi * 10.0;
  EXPECT_EQ(set.header.quantity, Quantity::receptance);
  EXPECT_EQ(set.values[0], Complex(1.0, 0.5));
  EXPECT_NEAR(std::abs(set.values[1] + Complex(1.0, 0.5) / (omega * omega)), 0.0, 1e-17);
}

TEST(UffRead, QuantityIsAskedFor) {
  Record record = simple_record();
  for (const auto& [above, below] : {std::pair{0, 0}, {1, 0}, {12, 0}, {1, 13}}) {
    record.numerator_type = above;
    record.denominator_type = below;
    EXPECT_THAT(load_error(record.str()), AllOf(HasSubstr("[data.files.\"NAME\"]"), HasSubstr("--quantity")));
    EXPECT_EQ(load_text(record.str(), as(Quantity::mobility)).header.quantity, Quantity::mobility);
  }
  record.numerator_type = 13;
  record.denominator_type = 12;
  EXPECT_THAT(load_error(record.str()), HasSubstr("data type 13 over 12"));
  const FrfHeader overridden = load_text(simple_record().str(), as(Quantity::mobility)).header;
  EXPECT_EQ(overridden.quantity, Quantity::mobility);
  EXPECT_THAT(overridden.changes, ::testing::ElementsAre("taken for mobility, not for the receptance that the file states"));
}

TEST(UffRead, Factors164Divide) {
  Record record = simple_record();
  const std::string millimetres = units_164(1000.0, 10.0);
  EXPECT_NEAR(load_text(millimetres + record.str()).values[0].real(), 1.0 * 10.0 / 1000.0, 1e-16);
  record.response_direction = 4;
  EXPECT_NEAR(load_text(millimetres + record.str()).values[0].real(), 1.0 * 10.0, 1e-14);
  record.reference_direction = 4;
  EXPECT_NEAR(load_text(millimetres + record.str()).values[0].real(), 1.0 * 10.0 * 1000.0, 1e-11);
  EXPECT_THAT(load_error(units_164(0.0, 1.0) + record.str()), HasSubstr("two positive unit factors"));
}

TEST(UffRead, UnitLabelsScaleOnce) {
  Record record = simple_record();
  record.numerator_type = 12;
  const double plain = load_text(record.str()).values[0].real();
  const auto scale = [&](const std::string& above, const std::string& below, const std::string& units) {
    record.numerator_unit = above;
    record.denominator_unit = below;
    return load_text(units + record.str()).values[0].real() / plain;
  };
  const std::string millimetres = units_164(1000.0, 10.0);
  EXPECT_NEAR(scale("g", "N", ""), 9.80665, 1e-14);
  EXPECT_NEAR(scale("g/N", "N", ""), 9.80665, 1e-14);
  EXPECT_NEAR(scale("mm/s^2", "NONE", ""), 1e-3, 1e-18);
  EXPECT_NEAR(scale("(mm/s\xC2\xB2)/N", "NONE", ""), 1e-3, 1e-18);
  EXPECT_NEAR(scale("(mm/s\xB2)/N", "NONE", ""), 1e-3, 1e-18);
  EXPECT_NEAR(scale("mm/s^2", "NONE", millimetres), 1e-3 * 10.0, 1e-16);  // length by label, force by 164
  EXPECT_NEAR(scale("NONE", "kN", millimetres), 1e-3 / 1e3, 1e-20);
  EXPECT_NEAR(scale("g/kN", "lbf", millimetres), 9.80665e-3, 1e-17);  // the label of record 9 settles both
}

TEST(UffRead, LabelsAgainstTypes) {
  Record record = simple_record();
  record.numerator_unit = "m/s^2";
  EXPECT_THAT(load_error(record.str()),
              AllOf(HasSubstr("record 9"), HasSubstr("data type 8 makes it receptance"),
                    HasSubstr("'m/s^2' makes it accelerance"), HasSubstr("--quantity")));
  EXPECT_EQ(load_text(record.str(), as(Quantity::accelerance)).header.quantity, Quantity::accelerance);
  EXPECT_EQ(load_text(record.str(), as(Quantity::receptance)).values, simple_values);
}

TEST(UffRead, AbscissaUnits) {
  Record record = simple_record();
  record.abscissa_unit = "kHz";
  EXPECT_EQ(load_text(record.str()).header.frequency_hz[1], 11000.0);
  record.abscissa_unit = "rad/s";
  EXPECT_NEAR(load_text(record.str()).header.frequency_hz[1], 11.0 / (2.0 * std::numbers::pi), 1e-15);
  record.abscissa_type = 17;
  EXPECT_THAT(load_error(record.str()), HasSubstr("not a frequency"));
}

TEST(UffRead, Coherences) {
  Record coherence = simple_record();
  coherence.function_type = 6;
  coherence.data_type = 4;
  coherence.numerator_type = coherence.denominator_type = 0;
  coherence.data = "  9.000000000000E-01  8.000000000000E-01  7.000000000000E-01\n";
  coherence.id = "Averages: 25";
  const FrfSet set = load_text(simple_record().str() + coherence.str());
  EXPECT_EQ(set.header.noise, NoiseRecord::coherence);
  EXPECT_EQ(set.header.averages, 25.0);
  EXPECT_EQ(set.coherence, (std::vector<double>{0.9, 0.8, 0.7}));
  Record other = simple_record();
  other.response_node = 2;
  EXPECT_EQ(load_text(simple_record().str() + coherence.str() + other.str()).header.noise, NoiseRecord::none);
}

TEST(UffRead, Geometry) {
  const std::string old =
      "    -1\n    15\n         4         0         0         0  1.00000E+03 -2.00000E+03  0.00000E+00\n"
      "         5         9         0         0  1.00000E+03 -2.00000E+03  0.00000E+00\n    -1\n";
  const std::string current =
      "    -1\n  2411\n         4         1         1        11\n"
      "   7.0000000000000000D+00   0.0000000000000000D+00   0.0000000000000000D+00\n"
      "         8         1         1        11\n"
      "   7.0000000000000000D+00   2.5000000000000000D+02   0.0000000000000000D+00\n    -1\n";
  const FrfSet set = load_text(units_164(1000.0, 1.0) + old + current + simple_record().str());
  ASSERT_EQ(set.header.nodes.size(), 2u);  // node 5 is defined in a system of its own, node 4 twice
  EXPECT_EQ(set.header.nodes[0].id, 4);
  EXPECT_EQ(set.header.nodes[0].position, (std::array{1.0, -2.0, 0.0}));
  EXPECT_EQ(set.header.nodes[1].position, (std::array{0.007, 0.25, 0.0}));
}

TEST(UffRead, FilesWithoutFrfs) {
  Record record = simple_record();
  record.function_type = 1;
  EXPECT_THAT(load_error(record.str() + units_164(1.0, 1.0)),
              AllOf(HasSubstr("no frequency response functions"), HasSubstr("1 x time response"),
                    HasSubstr("1 x dataset 164")));
  EXPECT_THAT(load_error("frequency,1,2\n"), HasSubstr("not a UFF file"));
  EXPECT_THAT(load_error(""), HasSubstr("holds no datasets"));
  EXPECT_THAT(error_of([] { open_uff("/nowhere/at/all.uff"); }), HasSubstr("cannot open"));
  const TemporaryUff file(simple_record().str());
  EXPECT_THAT(error_of([&] { read_uff58(file, 1); }),
              HasSubstr("record 2 of dataset 58 does not exist, there are 1"));
}

OpenOptions spectra(OpenOptions::Spectra wanted) {
  OpenOptions options;
  options.spectra = wanted;
  return options;
}

Record spectrum(int numerator_type, const std::string& unit) {
  Record record = simple_record();
  record.function_type = 12;
  record.reference_node = record.reference_direction = record.denominator_type = 0;
  record.numerator_type = numerator_type;
  record.numerator_unit = unit;
  return record;
}

/// The accelerometer and the force cell of a driving point have the same DOF.
TEST(UffRead, SpectraOfMotionsOrOfForces) {
  using enum OpenOptions::Spectra;
  Record acceleration = spectrum(12, "mm/s^2");
  acceleration.response_direction = -3;
  const std::string both = acceleration.str() + spectrum(13, "kN").str();
  const FrfSet motion = load_text(both, spectra(motions)), force = load_text(both, spectra(forces));
  EXPECT_EQ(motion.header.quantity, Quantity::accelerance);
  EXPECT_EQ(motion.header.response, std::vector<Dof>{Dof::parse("1:-Z")});
  EXPECT_EQ(motion.header.reference.size(), 1u);
  EXPECT_EQ(force.header.response, std::vector<Dof>{Dof::parse("1:+Z")});
  EXPECT_EQ(force.header.quantity, Quantity::receptance);
  for (std::size_t i = 0; i < simple_values.size(); ++i) {
    const double omega = 2.0 * std::numbers::pi * force.header.frequency_hz[i];
    EXPECT_NEAR(std::abs(force.values[i] - 1e3 * simple_values[i]), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(motion.values[i] + 1e-3 * simple_values[i] / (omega * omega)), 0.0, 1e-18);
  }
}

TEST(UffRead, UnitsOfSpectra) {
  using enum OpenOptions::Spectra;
  // Without labels dataset 164 holds, with its factors for lengths and forces.
  EXPECT_NEAR(std::abs(load_text(units_164(1000.0, 1.0) + spectrum(8, "NONE").str(), spectra(motions)).values[0]),
              1e-3 * std::abs(simple_values[0]), 1e-15);
  EXPECT_NEAR(std::abs(load_text(units_164(1000.0, 0.001) + spectrum(13, "NONE").str(), spectra(forces)).values[0]),
              1e3 * std::abs(simple_values[0]), 1e-9);
  Record moment = spectrum(13, "N*mm");
  moment.response_direction = 5;
  EXPECT_NEAR(std::abs(load_text(moment.str(), spectra(forces)).values[0]), 1e-3 * std::abs(simple_values[0]), 1e-15);
  // A type that says nothing: the unit tells forces from motions, and the quantity of motions is for the user to say.
  EXPECT_THAT(load_error(spectrum(0, "N").str(), spectra(motions)), HasSubstr("nor spectra of motions"));
  EXPECT_EQ(load_text(spectrum(0, "m/s").str(), [&] {
              OpenOptions options = spectra(motions);
              options.quantity = Quantity::mobility;
              return options;
            }()).header.quantity,
            Quantity::mobility);
  EXPECT_THAT(load_error(spectrum(0, "NONE").str(), spectra(motions)), HasSubstr("do not state which quantity"));
}

TEST(UffRead, SpectraThatAreNotPhasorsOfOneState) {
  using enum OpenOptions::Spectra;
  const std::string one = spectrum(8, "m").str();
  EXPECT_THAT(load_error(one), AllOf(HasSubstr("no frequency response functions"), HasSubstr("1 x ")));
  EXPECT_THAT(load_error(one, spectra(forces)), AllOf(HasSubstr("nor spectra of forces"), HasSubstr("function type 12")));
  EXPECT_THAT(load_error(one + one, spectra(motions)), AllOf(HasSubstr("the spectrum of 1:+Z is already in"), HasSubstr("force level")));
  Record real = spectrum(8, "m");
  real.data_type = 4;
  real.data = "  1.000000000000E+00  2.000000000000E+00  3.000000000000E+00\n";
  EXPECT_THAT(load_error(real.str(), spectra(motions)), HasSubstr("it has no phases"));
  // FRFs are what they always were, wherever spectra may be.
  EXPECT_EQ(load_text(one + simple_record().str(), spectra(motions)).header.reference, std::vector<Dof>{Dof::parse("1:+Z")});
}

TEST(UffRead, HeaderErrorsNameTheRecord) {
  std::string text = simple_record().str();
  text.replace(text.find("         6         3"), 10, "         x");
  EXPECT_THAT(load_error(text),
              AllOf(HasSubstr("dataset 58 number 1, record 7 (byte 7)"), HasSubstr("'x' in columns 1-10")));
}

/// Bytes that the process has from the C library; 0 under the sanitizers, which have their own.
std::size_t bytes_in_use() {
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(UffRead, RecordsThatShareNoDofTakeNoMoreThanTheyAre) {
  std::string bytes;
  for (int node = 1; node <= 1500; ++node) {
    Record record = simple_record(node);
    record.response_node = record.reference_node = node;
    bytes += record.str();
  }
  const TemporaryUff file(bytes);
  const std::size_t before = bytes_in_use();
  const auto source = open_uff(file);
  EXPECT_LT(bytes_in_use(), before + 4 * bytes.size());
  const std::vector<std::size_t> line = {1}, pair = {7, 1499};
  std::vector<Complex> values(4);
  source->read({line, pair, pair}, values);
  EXPECT_EQ(values[0], Complex(9.0, 4.5));
  EXPECT_TRUE(std::isnan(values[1].real()) && std::isnan(values[2].real()));
  EXPECT_EQ(values[3], Complex(1501.0, 750.5));
}

}  // namespace
}  // namespace jointid::frf
