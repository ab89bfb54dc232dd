#include <gmock/gmock.h>
#include <matio.h>

#include "file_fixture.hpp"
#include "frf/mat/mat_file.hpp"

namespace jointid::frf {
namespace {

using ::testing::HasSubstr;

/// Damage that an older reader handed on to matio, which asked for gigabytes or took wrong numbers.
class MatV5Damage : public FileTest {
 protected:
  /// frequency [3,1] and frf [3,2], double, then a cell array of two DOFs.
  void make(matio_compression compression) const {
    mat_t* file = Mat_CreateVer(path("a.mat").c_str(), nullptr, MAT_FT_MAT5);
    std::vector<double> hz = {10, 20, 30}, re = {1, 2, 3, 4, 5, 6}, im = {6, 5, 4, 3, 2, 1};
    std::size_t three[] = {3, 1}, six[] = {3, 2}, text[] = {1, 4}, cells[] = {2, 1};
    mat_complex_split_t split{re.data(), im.data()};
    char first[] = "1:+Y", second[] = "2:+Y";
    matvar_t* names[] = {Mat_VarCreate("", MAT_C_CHAR, MAT_T_UTF8, 2, text, first, 0),
                         Mat_VarCreate("", MAT_C_CHAR, MAT_T_UTF8, 2, text, second, 0), nullptr};
    for (matvar_t* variable : {Mat_VarCreate("frequency", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, three, hz.data(), 0),
                               Mat_VarCreate("frf", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, six, &split, MAT_F_COMPLEX),
                               Mat_VarCreate("response_dof", MAT_C_CELL, MAT_T_CELL, 2, cells, names, 0)}) {
      Mat_VarWrite(file, variable, compression);
      Mat_VarFree(variable);
    }
    Mat_Close(file);
  }

  std::string bytes() const {
    std::ifstream in(path("a.mat"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  FrfSet read() const {
    OpenOptions options;
    options.quantity = Quantity::receptance;
    options.reference = dofs({"1:+Y"});
    return load(*open_mat_v5(path("a.mat"), options));
  }

  /// What is said of the file with other bytes from `at` on.
  std::string with(std::size_t at, const std::string& other) const {
    make(MAT_COMPRESSION_NONE);
    std::string text = bytes();
    text.replace(at, other.size(), other);
    write_file("a.mat", text);
    return message_of([&] { read(); });
  }
};

// Where things stand: header 128; frequency: tag 128, flags 136, dimensions 152 (extents 160, 164), name 168.
TEST_F(MatV5Damage, ADeclaredSizeIsCheckedAgainstWhatIsThere) {
  EXPECT_THAT(with(160, std::string("\x00\x00\x00\x20", 4)),
              HasSubstr("variable number 1: is damaged or truncated: it declares 536870912 elements and holds 3"));
  EXPECT_THAT(with(160, std::string("\xff\xff\xff\xff", 4)), HasSubstr("a dimension is negative"));
  EXPECT_THAT(with(132, std::string("\xff\xff\xff\x7f", 4)), HasSubstr("a size goes beyond the end of the file"));
  EXPECT_THAT(with(156, std::string("\xf8\xff\xff\x0f", 4)), HasSubstr("its dimensions take 268435448 bytes"));
  EXPECT_THAT(with(172, std::string("\xff\xff\xff\x0f", 4)), HasSubstr("a name has 268435455 bytes"));
}

TEST_F(MatV5Damage, WhatTheFormatDoesNotHaveIsAnError) {
  EXPECT_THAT(with(124, std::string("\x00\x02", 2)), HasSubstr("its header is no such of version 5"));  // matio takes it for HDF5
  EXPECT_THAT(with(126, "XX"), HasSubstr("its header is no such of version 5"));                        // and this for version 4
  EXPECT_THAT(with(128, std::string("\x07", 1)), HasSubstr("it is no array but of type 7"));
  EXPECT_THAT(with(136, std::string("\x05", 1)), HasSubstr("an element has type 5 instead of 6"));
  EXPECT_THAT(with(144, std::string("\x3f", 1)), HasSubstr("class 63 is unknown"));
  EXPECT_THAT(with(144, std::string("\x01", 1)), HasSubstr("an element has type 9 instead of 14"));  // a cell array of numbers
}

TEST_F(MatV5Damage, CellsOfCellsHaveAnEnd) {
  const auto array = [](char kind, int extent, const std::string& inside) {
    std::string text("\x06\0\0\0\x08\0\0\0", 8);
    text += kind + std::string(7, '\0') + std::string("\x05\0\0\0\x08\0\0\0", 8);
    for (const int n : {extent, 1}) {
      for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(n >> shift);
    }
    text += std::string("\x01\0\0\0\0\0\0\0", 8) + inside;
    std::string tag("\x0e\0\0\0", 4);
    for (int shift = 0; shift < 32; shift += 8) tag += static_cast<char>(text.size() >> shift);
    return tag + text;
  };
  std::string header = "MATLAB 5.0 MAT-file";
  header.resize(124, ' ');
  header += std::string("\0\x01IM", 4);
  std::string deep;
  for (int depth = 0; depth < 100; ++depth) deep = array(1, depth == 0 ? 0 : 1, deep);
  write_file("a.mat", header + deep);
  EXPECT_THAT(message_of([&] { read(); }), HasSubstr("its arrays are nested too deep"));
  write_file("a.mat", header + array(1, 1'000'000'000, ""));
  EXPECT_THAT(message_of([&] { read(); }), HasSubstr("it holds 1000000000 arrays, more than a file of this size can"));
}

TEST_F(MatV5Damage, APackedVariableMustAgreeWithItsChecksum) {
  make(MAT_COMPRESSION_ZLIB);
  EXPECT_EQ(read().values[1], Complex(4, 3));
  std::string text = bytes();
  const std::size_t length = static_cast<unsigned char>(text[132]) + 256U * static_cast<unsigned char>(text[133]);
  text[136 + length - 1] = static_cast<char>(text[136 + length - 1] ^ 1);
  write_file("a.mat", text);
  EXPECT_THAT(
      message_of([&] { read(); }),
      HasSubstr("variable frequency: is damaged or truncated: its packed data cannot be unpacked (incorrect data check)"));
}

/// Every byte of a file set to others: an answer or an InputError, nothing printed.
TEST_F(MatV5Damage, AnyByteMayBeWrong) {
  ::testing::internal::CaptureStderr();
  std::size_t refused = 0;
  for (const matio_compression compression : {MAT_COMPRESSION_NONE, MAT_COMPRESSION_ZLIB}) {
    make(compression);
    const std::string good = bytes();
    for (std::size_t at = 0; at < good.size(); ++at) {
      std::string bad = good;
      bad[at] = static_cast<char>(bad[at] ^ (at % 2 == 0 ? 0x80 : 0x05));
      write_file("a.mat", bad);
      try {
        read();
      } catch (const InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(refused, 200U);
}

}  // namespace
}  // namespace jointid::frf
