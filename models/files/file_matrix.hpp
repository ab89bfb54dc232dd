#pragma once

#include <Eigen/SparseCore>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace jointid::models {

/// What a program calls a row of its matrices: a node and 1 to 6 for X to RZ. Others (0 of scalar points, Lagrange multipliers)
/// are rows without a DOF.
struct RowLabel {
  std::int64_t node = 0;
  int component = 0;
  auto operator<=>(const RowLabel&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 sees a 0 in it
};

/// A square matrix as a file holds it, every element in its place whatever triangle the file lists.
struct FileMatrix {
  Eigen::SparseMatrix<double> real;
  Eigen::SparseMatrix<double> imaginary;  ///< of no rows: the matrix is real
  std::vector<RowLabel> labels;           ///< of the rows, ascending; empty: the file has none
  std::string stated_unit{};              ///< one other than SI that the file states, and where; empty: none
};

constexpr std::size_t most_sparse_rows = 2000000;

/// Elements as a file lists them. An element that is listed twice is an error of the file.
class FileElements {
 public:
  explicit FileElements(std::filesystem::path file) : file_(std::move(file)) {}

  void add(std::size_t row, std::size_t column, double re, double im = 0.0) {
    real_.emplace_back(static_cast<int>(row), static_cast<int>(column), re);
    if (im != 0.0) imaginary_.emplace_back(static_cast<int>(row), static_cast<int>(column), im);
  }

  enum class Mirror {
    none,          ///< all elements are listed
    always,        ///< one triangle is listed
    where_missing  ///< one triangle or all
  };

  /// n × n. Throws InputError (data) for elements listed twice, in either triangle too where Mirror::always.
  FileMatrix matrix(std::size_t n, Mirror mirror, std::vector<RowLabel> labels = {}) const;

 private:
  using Triplets = std::vector<Eigen::Triplet<double>>;
  Eigen::SparseMatrix<double> filled(const Triplets& from, std::size_t n, Mirror mirror) const;

  std::filesystem::path file_;
  Triplets real_, imaginary_;
};

/// A number of Nastran: exponents with E, D or their sign alone, "1.2-3". False for anything else, NaN and infinity.
bool parse_real(std::string text, double& value);

}  // namespace jointid::models
