// Matrices of other programs, written by hand from their formats' descriptions: each gives the same matrix; damaged ones give an
// error.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <Eigen/Core>
#include <algorithm>
#include <cstring>
#include <fstream>
#include <limits>
#include <tuple>
#include <utility>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "models/files/matrix_file.hpp"
#include "models/model_file.hpp"
#include "tests/test_folder.hpp"

namespace jointid::models {
namespace {

using testing::HasSubstr;

/// 4 × 4 with gaps, in whole numbers that single precision holds.
Eigen::MatrixXd sample() {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(4, 4);
  m << 2.0, -1.0, 0.0, 5.0, -1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 4.0, 0.5, 5.0, 0.0, 0.5, 6.0;
  return m;
}

class MatrixFormats : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  void expect_refused(const std::string& text, const std::string& problem, const std::string& name = "bad.txt",
                      const std::string& variable = {}) const {
    try {
      read_file_matrix(write(name, text), variable);
      ADD_FAILURE() << "accepted, not: " << problem << "\n" << text.substr(0, 300);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem));
    }
  }

  TestFolder folder_;
};

/// OUTPUT4 in binary.
class Op4Bytes {
 public:
  Op4Bytes(bool swapped, int type, bool long_words) : swapped_(swapped), type_(type), long_words_(long_words) {}

  void head(std::int32_t columns, std::int32_t rows, std::int32_t form, std::string name) {
    begin();
    for (const std::int32_t value : {columns, rows, form, type_}) integer(value);
    name.resize(long_words_ ? 16 : 8, ' ');
    record_ += name;
    end();
  }
  void begin() { record_.clear(); }
  template <class T>
  void put(T value) {
    std::string bytes(sizeof(T), '\0');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (swapped_) std::ranges::reverse(bytes);
    record_ += bytes;
  }
  void integer(std::int32_t value) { long_words_ ? put(static_cast<std::int64_t>(value)) : put(value); }
  void number(double re, double im = 0.0) {
    for (const double value : {re, im}) {
      if (type_ % 2 == 1 && !long_words_)
        put(static_cast<float>(value));
      else
        put(value);
      if (type_ < 3) return;
    }
  }
  void end() {
    const std::string content = std::exchange(record_, {});
    put(static_cast<std::int32_t>(content.size()));
    const std::string length = std::exchange(record_, {});
    text += length + content + length;
  }
  std::int32_t words() const {
    if (long_words_) return type_ > 2 ? 2 : 1;
    return type_ == 1 ? 1 : type_ == 4 ? 4 : 2;
  }

  std::string text;

 private:
  bool swapped_;
  std::int32_t type_;
  bool long_words_;
  std::string record_;
};

/// Runs of elements that are not 0: first row and count.
std::vector<std::pair<int, int>> runs(const Eigen::VectorXd& column) {
  std::vector<std::pair<int, int>> out;
  for (int i = 0; i < column.size(); ++i) {
    if (column(i) == 0.0) continue;
    if (!out.empty() && out.back().first + out.back().second == i)
      ++out.back().second;
    else
      out.emplace_back(i, 1);
  }
  return out;
}

std::string op4_binary(const Eigen::MatrixXd& m, bool swapped, int type, char form, bool long_words = false) {
  Op4Bytes out(swapped, type, long_words);
  const auto n = static_cast<std::int32_t>(m.rows());
  out.head(n, form == 'b' ? -n : n, 6, "KAA");
  const auto words = out.words();
  for (std::int32_t j = 0; j < n; ++j) {
    out.begin();
    if (form == 'd') {
      for (const std::int32_t value : {j + 1, 1, n * words}) out.integer(value);
      for (std::int32_t i = 0; i < n; ++i) out.number(m(i, j), 2.0 * m(i, j));
    } else {
      const std::int32_t heading = form == 'b' ? 2 : 1;
      std::int32_t all = 0;
      for (const auto& [row, count] : runs(m.col(j))) all += heading + count * words;
      for (const std::int32_t value : {j + 1, 0, all}) out.integer(value);
      for (const auto& [row, count] : runs(m.col(j))) {
        if (form == 'b') {
          out.integer(count * words + 1);
          out.integer(row + 1);
        } else {
          out.integer(row + 1 + 65536 * (count * words + 1));
        }
        for (int i = row; i < row + count; ++i) out.number(m(i, j), 2.0 * m(i, j));
      }
    }
    out.end();
  }
  out.begin();
  for (const std::int32_t value : {n + 1, 1, words}) out.integer(value);
  out.number(1.0);
  out.end();
  return out.text;
}

class Op4InBinary : public MatrixFormats, public testing::WithParamInterface<std::tuple<bool, int, char, bool>> {};

TEST_P(Op4InBinary, IsRead) {
  const auto [swapped, type, form, long_words] = GetParam();
  const FileMatrix read = read_file_matrix(write("k.op4", op4_binary(sample(), swapped, type, form, long_words)), "KAA");
  EXPECT_EQ(Eigen::MatrixXd(read.real), sample());
  EXPECT_EQ(read.imaginary.rows() > 0, type > 2);
  if (type > 2) {
    EXPECT_EQ(Eigen::MatrixXd(read.imaginary), 2.0 * sample());
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Op4InBinary,
                         testing::Combine(testing::Bool(), testing::Range(1, 5), testing::Values('d', 's', 'b'), testing::Bool()));

/// One integer of a string holds no row beyond 65,535: Nastran takes two from there on, and some write the rows as a positive number.
TEST_F(MatrixFormats, Op4OfManyRows) {
  constexpr std::int32_t rows = 70000;
  for (const bool long_words : {false, true}) {
    Op4Bytes out(false, 2, long_words);
    out.head(rows, rows, 6, "KAA");
    for (const std::int32_t column : {1, rows}) {
      out.begin();
      for (const std::int32_t value : {column, 0, 2 + out.words(), out.words() + 1, column}) out.integer(value);
      out.number(column);
      out.end();
    }
    out.begin();
    for (const std::int32_t value : {rows + 1, 1, out.words()}) out.integer(value);
    out.number(1.0);
    out.end();
    const FileMatrix read = read_file_matrix(write("many.op4", out.text));
    EXPECT_EQ(read.real.nonZeros(), 2);
    EXPECT_EQ(read.real.coeff(0, 0), 1.0);
    EXPECT_EQ(read.real.coeff(rows - 1, rows - 1), rows);
  }
}

const std::string op4_dense =
    "       2       2       6       2KAA     1P,3E23.16\n"
    "       1       1       2\n 2.0000000000000000E+00-1.0000000000000000E+00\n"
    "       2       1       2\n-1.0000000000000000E+00 3.0000000000000000E+00\n"
    "       3       1       1\n 1.0000000000000000E+00\n";
const std::string op4_strings =
    "       2       2       6       2MAA     1P,3E23.16\n"
    "       1       0       5\n  327681\n 2.0000000000000000E+00-1.0000000000000000E+00\n"
    "       2       0       6\n  196609\n-1.0000000000000000D+00\n  196610\n 3.0000000000000000E+00\n"
    "       3       1       1\n 1.0000000000000000E+00\n";
const std::string op4_big =
    "       2      -2       1       4K       1P,3E23.16\n"
    "       1       0      10\n       9       1\n 2.0000000000000000E+00 4.0000000000000000E-01-1.0000000000000000E+00\n "
    "0.0000000000000000E+00\n"
    "       2       0      10\n       9       1\n-1.0000000000000000E+00 0.0000000000000000E+00 3.0000000000000000E+00\n "
    "6.0000000000000000E-01\n"
    "       3       1       1\n 1.0000000000000000E+00\n";

TEST_F(MatrixFormats, Op4InText) {
  Eigen::MatrixXd small(2, 2);
  small << 2.0, -1.0, -1.0, 3.0;
  EXPECT_EQ(Eigen::MatrixXd(read_file_matrix(write("k.op4", op4_dense)).real), small);
  EXPECT_EQ(Eigen::MatrixXd(read_file_matrix(write("m.op4", op4_strings)).real), small);
  const FileMatrix complex = read_file_matrix(write("c.op4", op4_big));
  EXPECT_EQ(Eigen::MatrixXd(complex.real), small);
  EXPECT_EQ(Eigen::MatrixXd(complex.imaginary), (Eigen::Matrix2d() << 0.4, 0.0, 0.0, 0.6).finished());
  const auto both = write("both.op4", op4_dense + op4_strings);
  EXPECT_EQ(Eigen::MatrixXd(read_file_matrix(both, "MAA").real), small);
  expect_refused(op4_dense + op4_strings, "several matrices: KAA, MAA");
  expect_refused(op4_dense, "there are: KAA", "bad.op4", "MAA");
}

TEST_F(MatrixFormats, HostileOp4) {
  for (const std::string& whole : {op4_dense, op4_strings, op4_big}) {
    for (std::size_t end = 60; end + 20 < whole.size(); end += 13) {
      EXPECT_THROW(read_file_matrix(write("cut.op4", whole.substr(0, end))), InputError) << whole.substr(0, end);
    }
  }
  const std::string binary = op4_binary(sample(), false, 2, 's');
  for (const std::string& whole : {binary, op4_binary(sample(), true, 2, 'b', true)}) {
    for (std::size_t end = 40; end < whole.size(); end += 7)
      EXPECT_THROW(read_file_matrix(write("cut.op4", whole.substr(0, end))), InputError) << end;
  }
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(with(op4_dense, " 2.0000000000000000E+00", "                    NaN"), "is no number");
  expect_refused(with(op4_dense, "       2       2       6", "99999999       2       6"), "1 to 2000000 rows");
  expect_refused(with(op4_dense, "       6       2KAA", "       3       2KAA"), "form 3");
  expect_refused(with(op4_dense, "       6       2KAA", "       6       7KAA"), "type 7");
  expect_refused(with(op4_strings, "  327681", "99999999"), "has 2 numbers");
  expect_refused(with(op4_strings, "       5\n", "      99\n"), "numbers");
  std::string doubled = binary;
  for (const auto& [at, value] : {std::pair<std::size_t, std::int32_t>{4, 1999999999}, {16, 9}, {12, 3}}) {
    doubled = binary;
    std::memcpy(doubled.data() + at, &value, 4);
    EXPECT_THROW(read_file_matrix(write("bad.op4", doubled)), InputError) << at;
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  doubled = op4_binary(sample(), true, 2, 'd');
  std::memcpy(doubled.data() + 32 + 4 + 12, &nan, 8);
  std::reverse(doubled.begin() + 48, doubled.begin() + 56);
  expect_refused(doubled, "no finite number");
  const std::string long_integers = std::string("\x30\0\0\0", 4) + std::string(48, '\1') + std::string("\x30\0\0\0", 4);
  expect_refused(long_integers, "is none of 1 to 4");
}

/// Grid points in another order than rows; a symmetric matrix in its lower triangle.
const std::string dmig_small =
    "$ punched\n"
    "DMIG    KAAX    0       6       2       0                       2\n"
    "DMIG    KAAX    12      1               12      1       2.0D+0\n"
    "        7       3       -1.0\n"
    "DMIG*   KAAX                           7               3\n"
    "*                      7               3  3.000000000D+00\n";
const std::string dmig_free =
    "DMIG,MAAX,0,1,2,0,,,2\n"
    "DMIG,MAAX,7,3,,7,3,3.0\n,12,1,-1.+0\n"
    "DMIG,MAAX,12,1,,7,3,-1.0\n,12,1,20.-1\nENDDATA\n";

TEST_F(MatrixFormats, PunchedDmig) {
  Eigen::MatrixXd expected(2, 2);
  expected << 3.0, -1.0, -1.0, 2.0;  // 7:+Z, 12:+X
  for (const auto& [name, text] : {std::pair{"small.pch", dmig_small}, std::pair{"free.pch", dmig_free}}) {
    const FileMatrix read = read_file_matrix(write(name, text));
    EXPECT_EQ(Eigen::MatrixXd(read.real), expected) << name;
    EXPECT_EQ(read.labels, (std::vector<RowLabel>{{7, 3}, {12, 1}}));
  }
  EXPECT_EQ(read_file_matrix(write("both.pch", dmig_small + dmig_free), "MAAX").real.coeff(0, 0), 3.0);
}

TEST_F(MatrixFormats, HostileDmig) {
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(dmig_small + dmig_free, "several matrices: KAAX, MAAX");
  expect_refused(dmig_small, "there are: KAAX", "bad.pch", "KGG");
  expect_refused(with(dmig_small, "0       6 ", "0       9 "), "form 9");
  expect_refused(with(dmig_small, "2.0D+0", "NaN   "), "no finite number");
  expect_refused(with(dmig_small, "12      1       2.0", "12      9       2.0"), "component 9");
  expect_refused(dmig_small.substr(dmig_small.find("DMIG    KAAX    12")), "before its head");
  expect_refused(dmig_small + "DMIG    KAAX    7       3               12      1       -1.0\n", "both triangles");
  expect_refused(dmig_free + "DMIG,MAAX,7,3,,7,3,3.0\n", "listed twice");
}

TEST_F(MatrixFormats, AbaqusText) {
  Eigen::MatrixXd expected(2, 2);
  expected << 3.0, -1.0, -1.0, 2.0;
  const FileMatrix labelled =
      read_file_matrix(write("job_STIF1.mtx", "** comment\n12,1, 12,1,  2.0e+00\n12,1, 7,3, -1.0\n7,3, 7,3, 3.0\n"));
  EXPECT_EQ(Eigen::MatrixXd(labelled.real), expected);
  EXPECT_EQ(labelled.labels, (std::vector<RowLabel>{{7, 3}, {12, 1}}));
  EXPECT_EQ(
      Eigen::MatrixXd(read_file_matrix(write("whole.mtx", "7,3,7,3,3.0\n7,3,12,1,-1.0\n12,1,7,3,-1.0\n12,1,12,1,2.0\n")).real),
      expected);
  const FileMatrix placed = read_file_matrix(write("job_MASS1.mtx", "1 1 3.0\n2 1 -1.0\n2 2 2.0\n"));
  EXPECT_EQ(Eigen::MatrixXd(placed.real), expected);
  EXPECT_TRUE(placed.labels.empty());
  expect_refused("7,3,7,3,3.0\n7,3,7,3\n", "cells", "a.mtx");
  expect_refused("7,3,7,3,3.0\n7,3,8,x,1.0\n", "no whole number", "a.mtx");
  expect_refused("7,3,7,3,3.0\n7,3,8,1,inf\n", "no finite number", "a.mtx");
  expect_refused("7,3,7,3,3.0\n7,3,7,3,3.0\n", "listed twice", "a.mtx");
  expect_refused("7,3,7,3,3.0\n7,3,8,3,3.0\n8,3,7,3,4.0\n", "not symmetric", "a.mtx");
  expect_refused("1 1 3.0\n3000000 1 2.0\n", "2000000", "a.mtx");
}

TEST_F(MatrixFormats, MatrixMarketVariants) {
  const std::string head = "%%MatrixMarket matrix coordinate ";
  const FileMatrix pattern = read_file_matrix(write("p.mtx", head + "pattern symmetric\n2 2 2\n1 1\n2 1\n"));
  EXPECT_EQ(Eigen::MatrixXd(pattern.real), (Eigen::Matrix2d() << 1.0, 1.0, 1.0, 0.0).finished());
  const FileMatrix complex = read_file_matrix(write("c.mtx", head + "complex symmetric\n2 2 2\n1 1 2 0.5\n2 1 -1 0.25\n"));
  EXPECT_EQ(Eigen::MatrixXd(complex.real), (Eigen::Matrix2d() << 2.0, -1.0, -1.0, 0.0).finished());
  EXPECT_EQ(Eigen::MatrixXd(complex.imaginary), (Eigen::Matrix2d() << 0.5, 0.25, 0.25, 0.0).finished());
  expect_refused(head + "real skew-symmetric\n2 2 1\n2 1 3\n", "not symmetric", "s.mtx");
  expect_refused(head + "complex hermitian\n2 2 1\n2 1 3 1\n", "not symmetric", "h.mtx");
  expect_refused(head + "quaternion general\n2 2 1\n2 1 3\n", "quaternion", "q.mtx");
  expect_refused(head + "real diagonal\n2 2 1\n2 1 3\n", "diagonal", "d.mtx");
  expect_refused("%%MatrixMarket matrix array pattern general\n1 1\n", "pattern", "a.mtx");
}

/// Groups with data, ir and jc, as MATLAB v7.3 stores sparse matrices.
class SparseHdf5 {
 public:
  explicit SparseHdf5(const std::filesystem::path& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~SparseHdf5() { H5Fclose(file_); }
  SparseHdf5(const SparseHdf5&) = delete;
  SparseHdf5& operator=(const SparseHdf5&) = delete;

  void group(const std::string& name) { H5Gclose(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT)); }
  template <class T>
  void put(const std::string& name, hid_t type, const std::vector<T>& values) {
    const hsize_t count = values.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t set = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(set);
    H5Sclose(space);
  }
  void matrix(const std::string& name, const std::vector<std::uint64_t>& rows, const std::vector<std::uint64_t>& begins) {
    group(name);
    put(name + "/data", H5T_NATIVE_DOUBLE, std::vector<double>{3.0, -1.0, -1.0, 2.0});
    put(name + "/ir", H5T_NATIVE_UINT64, rows);
    put(name + "/jc", H5T_NATIVE_UINT64, begins);
  }

 private:
  hid_t file_;
};

TEST_F(MatrixFormats, SparseMatricesOfMatlab73) {
  const auto path = folder_ / "m.mat";
  {
    SparseHdf5 file(path);
    file.matrix("K", {0, 1, 0, 1}, {0, 2, 4});
    file.matrix("far", {0, 1, 0, 7}, {0, 2, 4});
    file.matrix("back", {0, 1, 0, 1}, {0, 3, 2});
    file.matrix("long", {0, 1, 0, 1}, {0, 2, 9});
  }
  EXPECT_EQ(Eigen::MatrixXd(read_file_matrix(path, "K").real), (Eigen::Matrix2d() << 3.0, -1.0, -1.0, 2.0).finished());
  for (const auto& [name, problem] : {std::pair{"far", "row 8"}, std::pair{"back", "ends before it begins"},
                                      std::pair{"long", "fewer elements"}, std::pair{"", "several matrices"}}) {
    try {
      read_file_matrix(path, name);
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(problem));
    }
  }
}

/// Rows of different files are put together by their labels; a complex stiffness is K + iD.
TEST_F(MatrixFormats, LabelledFilesAreOneModel) {
  write("k.pch", "DMIG,KAAX,0,6,4,0,,,2\nDMIG,KAAX,7,3,,7,3,3000.0,30.0\n,12,1,-1000.,-10.\nDMIG,KAAX,12,1,,12,1,2000.0,20.0\n");
  write("m.mtx", "12,1,12,1,2.0\n7,3,7,3,4.0\n7,4,7,4,0.1\n");
  const auto model = read_model(write("part.toml", "mass = \"m.mtx\"\nstiffness = \"k.pch\"\n"));
  EXPECT_EQ(frf::names(model.coordinates.dofs), (std::vector<std::string>{"7:+Z", "7:+RX", "12:+X"}));
  const double omega = 20.0;
  const std::vector<std::size_t> all = {0, 1, 2};
  const auto h = model.model->receptance(omega, all, all);
  ASSERT_TRUE(h);
  const Complex i(0.0, 1.0);
  Eigen::Matrix3cd z;
  z << 3000.0 + 30.0 * i - 4.0 * omega * omega, 0.0, -1000.0 - 10.0 * i, 0.0, -0.1 * omega * omega, 0.0, -1000.0 - 10.0 * i, 0.0,
      2000.0 + 20.0 * i - 2.0 * omega * omega;
  EXPECT_LT((z * *h - Eigen::Matrix3cd::Identity()).cwiseAbs().maxCoeff(), 1e-12);
  write("plain.mtx", "%%MatrixMarket matrix coordinate real general\n3 3 1\n1 1 1\n");
  EXPECT_THROW(read_model(write("mixed.toml", "mass = \"plain.mtx\"\nstiffness = \"k.pch\"\n")), InputError);
  EXPECT_THROW(read_model(write("both.toml", "mass = \"m.mtx\"\nstiffness = \"k.pch\"\nhysteretic_damping = \"m.mtx\"\n")),
               InputError);
  EXPECT_THROW(read_model(write("complex.toml", "mass = \"k.pch\"\nstiffness = \"k.pch\"\n")), InputError);
}

}  // namespace
}  // namespace jointid::models
