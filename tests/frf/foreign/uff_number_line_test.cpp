// Number lines of binary data that are written in other columns, letters that the format does not have, the wrong byte order.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstddef>

#include "frf/set/frf_source.hpp"
#include "tests/frf/uff_samples.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using namespace samples;

std::string with_number(const std::string& record, const std::string& line) {
  const std::size_t begin = record.find("    58"), end = record.find('\n', begin);
  return record.substr(0, begin) + line + record.substr(end);
}

const std::vector<double> six = {1.0, 0.5, 2.0, 1.0, 3.0, 1.5};

TEST(UffNumberLine, BinaryFieldsInOtherColumns) {
  const std::string record = binary_record(6, six).str();
  for (const char* line : {"58b 1 2 11 48 0 0 0 0", "    58 b    1     2    11    48", "     58b     1     2          11          48"}) {
    const TemporaryUff file(with_number(record, line));
    const FrfSet set = load(*open(file.path()));
    EXPECT_EQ(set.values, (std::vector<Complex>{{1.0, 0.5}, {2.0, 1.0}, {3.0, 1.5}})) << line;
  }
}

TEST(UffNumberLine, OtherLettersAreNamed) {
  for (const char* line : {"    58c", "    58a", "    58c     1     2          11          48"}) {
    const TemporaryUff file(with_number(simple_record().str(), line));
    EXPECT_THAT(error_of([&] { open(file.path()); }),
                AllOf(HasSubstr("is not a dataset number"), HasSubstr("58 for numbers as text, 58b for binary ones")));
  }
}

TEST(UffNumberLine, TheOtherByteOrderIsNamed) {
  std::vector<double> twelve = six;
  twelve.insert(twelve.end(), {1e-9, -2e-9, 4.7e-8, 1.1e-7, -0.31, 0.07});
  for (const bool big : {false, true}) {
    Record record = binary_record(6, twelve, big);
    record.points = 6;
    EXPECT_EQ(load(*open(TemporaryUff(record.str()).path())).header.lines(), 6U);
    record.byte_order = big ? 1 : 2;
    const TemporaryUff wrong(record.str());
    EXPECT_THAT(error_of([&] { open(wrong.path()); }),
                AllOf(HasSubstr("the numbers make no sense in byte order"), HasSubstr(big ? "do in 2 (big-endian)" : "do in 1 (little")));
  }
  const std::vector<float> single(twelve.begin(), twelve.end());
  Record record = binary_record(5, single);
  record.points = 6, record.byte_order = 2;
  const TemporaryUff wrong(record.str());
  EXPECT_THAT(error_of([&] { open(wrong.path()); }), HasSubstr("do in 1 (little-endian)"));
}

/// As Windows' Notepad saves "Unicode": a mark, then two bytes a character.
std::string utf16(const std::string& text, bool big) {
  std::string out = big ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) out.append(big ? std::string{'\0', c} : std::string{c, '\0'});
  return out;
}

std::string with_cr_alone(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

TEST(UffNumberLine, TextOfOtherLineEndsAndOfUtf16IsRead) {
  const std::string text = simple_record().str();
  const FrfSet right = load(*open(TemporaryUff(text).path()));
  for (const std::string& other : {with_cr_alone(text), utf16(text, false), utf16(text, true), utf16(with_cr_alone(text), false)}) {
    const TemporaryUff file(other);
    const FrfSet read = load(*open(file.path()));
    EXPECT_EQ(read.header.response, right.header.response);
    EXPECT_EQ(read.header.frequency_hz, right.header.frequency_hz);
    EXPECT_EQ(read.values, right.values);
  }
}

TEST(UffNumberLine, BinaryRecordsBetweenLinesThatEndWithCrAloneAreNamed) {
  const TemporaryUff file(with_cr_alone(binary_record(6, six).str()));
  EXPECT_THAT(error_of([&] { open(file.path()); }), HasSubstr("has binary records (58b), and its lines end with CR alone"));
}

}  // namespace
}  // namespace jointid::frf
