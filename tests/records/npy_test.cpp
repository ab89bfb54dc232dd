#include <gmock/gmock.h>

#include <cstring>
#include <fstream>

#include "base/error.hpp"
#include "records/file/npy_file.hpp"
#include "records/file/open_samples.hpp"
#include "tests/test_folder.hpp"

namespace jointid::records {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The bytes that numpy.save() writes of format 1.0: the header padded to 64 bytes.
std::string npy(const std::string& descr, const std::string& fortran, const std::string& shape, const std::string& numbers) {
  std::string header = "{'descr': '" + descr + "', 'fortran_order': " + fortran + ", 'shape': " + shape + ", }";
  header.resize((header.size() + 11 + 63) / 64 * 64 - 11, ' ');
  header += '\n';
  std::string bytes = "\x93NUMPY";
  bytes += {'\x01', '\x00', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  return bytes + header + numbers;
}

template <class T>
std::string bytes_of(const std::vector<T>& numbers, bool swapped = false) {
  std::string out;
  for (const T& number : numbers) {
    std::string one(sizeof(T), '\0');
    std::memcpy(one.data(), &number, sizeof(T));
    out += swapped ? std::string(one.rbegin(), one.rend()) : one;
  }
  return out;
}

class Npy : public ::testing::Test {
 protected:
  frf::Columns read(const std::string& bytes) const {
    std::ofstream(folder_ / "a.npy", std::ios::binary) << bytes;
    return read_npy(folder_ / "a.npy");
  }

  std::string message(const std::string& bytes) const {
    try {
      read(bytes);
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::data);
      return error.what();
    }
    return "nothing was thrown";
  }

  TestFolder folder_;
};

const std::vector<double> six = {1, 2, 3, 4, 5, 6};

TEST_F(Npy, ChannelsAreTheShorterAxisInEitherOrder) {
  const frf::Columns rows = read(npy("<f8", "False", "(2, 3)", bytes_of(six)));
  ASSERT_EQ(rows.columns.size(), 2u);
  EXPECT_THAT(rows.columns[0].values, ElementsAre(1, 2, 3));
  EXPECT_THAT(rows.columns[1].values, ElementsAre(4, 5, 6));
  EXPECT_EQ(rows.columns[1].name, "2");
  const frf::Columns columns = read(npy("<f8", "False", "(3, 2)", bytes_of(six)));
  EXPECT_THAT(columns.columns[0].values, ElementsAre(1, 3, 5));
  const frf::Columns fortran = read(npy("<f8", "True", "(3, 2)", bytes_of(six)));
  EXPECT_THAT(fortran.columns[1].values, ElementsAre(4, 5, 6));
  EXPECT_THAT(read(npy("<f8", "True", "(2, 3)", bytes_of(six))).columns[1].values, ElementsAre(2, 4, 6));
  EXPECT_THAT(read(npy("<f8", "False", "(6,)", bytes_of(six))).columns[0].values, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST_F(Npy, NumbersOfAllRealTypesAndBothByteOrders) {
  EXPECT_THAT(read(npy(">f8", "False", "(2,)", bytes_of<double>({0.5, -2}, true))).columns[0].values, ElementsAre(0.5, -2));
  EXPECT_THAT(read(npy("<f4", "False", "(2,)", bytes_of<float>({0.5F, -2}))).columns[0].values, ElementsAre(0.5, -2));
  EXPECT_THAT(read(npy("|i1", "False", "(2,)", bytes_of<std::int8_t>({-128, 127}))).columns[0].values, ElementsAre(-128, 127));
  EXPECT_THAT(read(npy("|u1", "False", "(2,)", bytes_of<std::uint8_t>({0, 255}))).columns[0].values, ElementsAre(0, 255));
  EXPECT_THAT(read(npy("<i2", "False", "(2,)", bytes_of<std::int16_t>({-32768, 3}))).columns[0].values, ElementsAre(-32768, 3));
  EXPECT_THAT(read(npy(">u2", "False", "(2,)", bytes_of<std::uint16_t>({65535, 3}, true))).columns[0].values,
              ElementsAre(65535, 3));
  EXPECT_THAT(read(npy(">i4", "False", "(2,)", bytes_of<std::int32_t>({-70000, 3}, true))).columns[0].values,
              ElementsAre(-70000, 3));
  EXPECT_THAT(read(npy("<u4", "False", "(1,)", bytes_of<std::uint32_t>({4000000000U}))).columns[0].values, ElementsAre(4e9));
  EXPECT_THAT(read(npy("<i8", "False", "(1,)", bytes_of<std::int64_t>({-5}))).columns[0].values, ElementsAre(-5));
}

TEST_F(Npy, WhatItIsNotIsSaid) {
  const std::string numbers = bytes_of(six);
  EXPECT_THAT(message(npy("<c16", "False", "(3,)", numbers)), HasSubstr("npy header: holds numbers of type '<c16'"));
  EXPECT_THAT(message(npy("|O", "False", "(6,)", numbers)), HasSubstr("holds numbers of type '|O'"));
  EXPECT_THAT(message(npy("=f8", "False", "(6,)", numbers)), HasSubstr("the byte order of '=f8' is unknown"));
  EXPECT_THAT(message(npy("<f8", "No", "(6,)", numbers)), HasSubstr("fortran_order is neither True nor False"));
  EXPECT_THAT(message(npy("<f8", "False", "(6, x)", numbers)), HasSubstr("the shape is not a list of sizes"));
  EXPECT_THAT(message(npy("<f8", "False", "()", numbers)), HasSubstr("the array has 0 axes"));
  EXPECT_THAT(message(npy("<f8", "False", "(1, 2, 3)", numbers)), HasSubstr("the array has 3 axes"));
  EXPECT_THAT(message(npy("<f8", "False", "(0, 6)", "")), HasSubstr("the array is empty"));
  EXPECT_THAT(message(npy("<f8", "False", "(4294967296, 4294967296)", numbers)), HasSubstr("more than 268 million numbers"));
  EXPECT_THAT(message(npy("<f8", "False", "(5,)", numbers)), HasSubstr("declares 40 bytes of numbers and the file holds 48"));
  EXPECT_THAT(message(npy("<f8", "False, 'descr': '<f8'", "(6,)", numbers)), HasSubstr("the key 'descr' is there twice"));
  EXPECT_THAT(message(npy("<f8", "False, 'more': 3", "(6,)", numbers)), HasSubstr("the key 'more' is none of"));
  std::string other = npy("<f8", "False", "(6,)", numbers);
  other[6] = 9;
  EXPECT_THAT(message(other), HasSubstr("format 9.0 is unknown"));
}

TEST_F(Npy, CutShortOrDamagedIsOneErrorOrTheArray) {
  const std::string whole = npy("<f8", "False", "(6,)", bytes_of(six));
  for (std::size_t keep = 6; keep < whole.size(); keep += 3)
    EXPECT_THAT(message(whole.substr(0, keep)), HasSubstr("a.npy: npy header")) << keep;
  for (std::size_t at = 0; at < 80; ++at) {
    for (const char change : {'\0', '\x7f', '(', '9'}) {
      std::string damaged = whole;
      damaged[at] = change;
      try {
        EXPECT_EQ(read(damaged).columns[0].values.size(), 6u);
      } catch (const InputError&) {
      }
    }
  }
}

/// An archive that numpy wrote (tests/records/foreign/make.py): as a stream its vectors are channels, without the times and a number.
TEST(Npz, VectorsAreChannelsOfAStream) {
  const auto stream = open_samples(std::filesystem::path(JOINTID_FOREIGN_RECORDS) / "record.npz");
  ASSERT_EQ(stream->channels().size(), 2u);
  EXPECT_EQ(stream->channels()[0].name, "F");
  EXPECT_EQ(stream->time_column(), "time");
  std::vector<double> rows(8, -1.0);
  EXPECT_EQ(stream->read(rows), 3u);
  EXPECT_THAT(rows, ElementsAre(0, 0, 5, 1, 1, -2, -1, -1));
}

}  // namespace
}  // namespace jointid::records
