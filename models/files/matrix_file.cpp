#include "models/files/matrix_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/file/variables.hpp"
#include "models/files/failure.hpp"
#include "models/files/labelled_matrix.hpp"
#include "models/files/nastran_op4.hpp"
#include "models/files/variable_matrix.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr std::size_t most_remarks = 100;
constexpr double most_rows = 20000.0;  ///< of full matrices
constexpr double symmetric_to = 1e-9;  ///< of the largest element

/// Reads a Matrix Market file line by line, comments left out.
class MarketReader {
 public:
  explicit MarketReader(const std::filesystem::path& path) : path_(path) {
    require_regular_file(path);
    in_.open(path);
    if (!in_) refuse_file(path_, "", "it cannot be read");
  }

  FileMatrix read() {
    std::string line;
    std::getline(in_, line);
    number_ = 1;
    std::istringstream head(line);
    std::string banner, object, format, field, symmetry;
    head >> banner >> object >> format >> field >> symmetry;
    for (std::string* word : {&object, &format, &field, &symmetry}) std::ranges::transform(*word, word->begin(), ::tolower);
    if (banner != "%%MatrixMarket" || object != "matrix") fail("the first line is not that of a Matrix Market matrix");
    if (format != "coordinate" && format != "array") fail("format '" + format + "' is unknown", "use coordinate or array");
    read_words(field, symmetry);
    if (field == "pattern" && format == "array") fail("a pattern has no values to list in an array", "use coordinate");
    return format == "coordinate" ? coordinates() : array();
  }

 private:
  void read_words(const std::string& field, const std::string& symmetry) {
    if (field == "pattern")
      values_ = 0;
    else if (field == "complex")
      values_ = 2;
    else if (field != "real" && field != "integer" && field != "double")
      fail("the matrix is '" + field + "'", "give real, integer, complex or pattern");
    if (symmetry == "symmetric")
      mirrored_ = mirrored_imaginary_ = 1.0;
    else if (symmetry == "skew-symmetric")
      mirrored_ = mirrored_imaginary_ = -1.0;
    else if (symmetry == "hermitian")
      mirrored_ = 1.0, mirrored_imaginary_ = -1.0;
    else if (symmetry != "general")
      fail("the matrix is '" + symmetry + "'", "give general, symmetric, skew-symmetric or hermitian");
  }

  [[noreturn]] void fail(std::string problem, std::string remedy = {}) const {
    refuse_file(path_, "line " + std::to_string(number_), std::move(problem), std::move(remedy));
  }

  std::vector<double> numbers(std::size_t count) {
    std::string line;
    do {
      if (!std::getline(in_, line)) fail("the file ends early");
      ++number_;
      if (line.starts_with('%') && remarks_.remarks.size() < most_remarks)
        remarks_.remarks.push_back({"line " + std::to_string(number_), line});
    } while (line.empty() || line[0] == '%' || line.find_first_not_of(" \t\r") == std::string::npos);
    std::istringstream text(line);
    std::vector<double> found(count);
    std::string word;
    for (double& value : found) {
      if (!(text >> word) || !parse_real(word, value)) fail("'" + line + "' is not " + std::to_string(count) + " numbers");
    }
    if (text >> word) fail("'" + line + "' is more than " + std::to_string(count) + " numbers");
    return found;
  }

  std::string stated_unit() const {
    const auto unread = frf::unread_unit(remarks_, [](const frf::Unit&) { return true; });
    return unread ? "the unit '" + unread->unit + "' in " + unread->place : std::string();
  }

  Eigen::Index index(double value, Eigen::Index end) const {
    if (!(value >= 1.0 && value <= static_cast<double>(end)) || value != std::floor(value))
      fail("there is no such row or column");
    return static_cast<Eigen::Index>(value) - 1;
  }

  void begin(double rows, double columns, double most) {
    if (!(rows >= 1.0 && rows <= most) || columns != rows || rows != std::floor(rows)) {
      fail("the matrix is not square with 1 to " + std::to_string(static_cast<long>(most)) + " rows");
    }
    rows_ = static_cast<Eigen::Index>(rows);
  }

  /// Of a pattern every element is 1.
  void add(Eigen::Index i, Eigen::Index j, std::span<const double> value) {
    const auto row = static_cast<int>(i), column = static_cast<int>(j);
    const double re = value.empty() ? 1.0 : value[0];
    entries_.emplace_back(row, column, re);
    if (mirrored_ != 0.0 && i != j) entries_.emplace_back(column, row, mirrored_ * re);
    if (value.size() < 2) return;
    imaginary_.emplace_back(row, column, value[1]);
    if (mirrored_ != 0.0 && i != j) imaginary_.emplace_back(column, row, mirrored_imaginary_ * value[1]);
  }

  /// A symmetric matrix lists one triangle, and no matrix an element twice.
  void require_once() const {
    std::vector<std::pair<int, int>> places;
    for (const Eigen::Triplet<double>& entry : entries_) places.emplace_back(entry.row(), entry.col());
    std::ranges::sort(places);
    const auto twice = std::ranges::adjacent_find(places);
    if (twice == places.end()) return;
    refuse_file(path_, "element (" + std::to_string(twice->first + 1) + ", " + std::to_string(twice->second + 1) + ")",
                "it is listed twice",
                mirrored_ != 0.0 ? "a symmetric matrix lists one triangle; write 'general' where all elements are listed"
                                 : "write the file again");
  }

  FileMatrix matrix() const {
    FileMatrix out{Sparse(rows_, rows_), {}, {}, stated_unit()};
    out.real.setFromTriplets(entries_.begin(), entries_.end());
    if (static_cast<std::size_t>(out.real.nonZeros()) != entries_.size()) require_once();
    if (values_ == 2) {
      out.imaginary.resize(rows_, rows_);
      out.imaginary.setFromTriplets(imaginary_.begin(), imaginary_.end());
    }
    return out;
  }

  FileMatrix coordinates() {
    const std::vector<double> size = numbers(3);
    begin(size[0], size[1], static_cast<double>(most_sparse_rows));
    for (double i = 0.0; i < size[2]; ++i) {
      const std::vector<double> entry = numbers(2 + values_);
      add(index(entry[0], rows_), index(entry[1], rows_), std::span(entry).subspan(2));
    }
    return matrix();
  }

  FileMatrix array() {
    const std::vector<double> size = numbers(2);
    begin(size[0], size[1], most_rows);
    for (Eigen::Index j = 0; j < rows_; ++j) {
      for (Eigen::Index i = mirrored_ == 0.0 ? 0 : mirrored_ < 0.0 ? j + 1 : j; i < rows_; ++i) add(i, j, numbers(values_));
    }
    return matrix();
  }

  const std::filesystem::path& path_;
  std::ifstream in_;
  std::size_t number_ = 0;
  std::size_t values_ = 1;                            ///< of an element
  double mirrored_ = 0.0, mirrored_imaginary_ = 0.0;  ///< factor of the element across the diagonal; 0: it is listed
  Eigen::Index rows_ = 0;
  std::vector<Eigen::Triplet<double>> entries_, imaginary_;
  frf::Columns remarks_;  ///< comments alone
};

/// A row of the matrix a line of text.
FileMatrix from_text(const std::filesystem::path& path, const std::string& variable) {
  if (!variable.empty()) refuse_file(path, variable, "there is no such matrix; the file holds rows of numbers", "leave out the name");
  const frf::Columns read = frf::read_columns(path);
  for (const frf::NumberColumn& column : read.columns) {
    if (!std::ranges::all_of(column.name, [](unsigned char c) { return std::isdigit(c) != 0; }))
      refuse_file(path, variable, "'" + column.name + "' is the title of a column, and rows of a matrix have none",
                  "leave the titles out; names of the coordinates are given by dofs");
  }
  const std::size_t size = read.columns.size();
  Eigen::MatrixXd m(at(size), at(size));
  for (std::size_t j = 0; j < size; ++j) {
    const std::vector<double>& values = read.columns[j].values;
    if (values.size() != size) {
      refuse_file(path, variable, "the matrix is not square: " + std::to_string(values.size()) + " × " + std::to_string(size));
    }
    for (std::size_t i = 0; i < size; ++i) m(at(i), at(j)) = values[i];
  }
  const auto unread = frf::unread_unit(read, [](const frf::Unit&) { return true; });
  return {Sparse(m.sparseView()), {}, {}, unread ? "the unit '" + unread->unit + "' in " + unread->place : std::string()};
}

/// Throws where an element and that across the diagonal differ.
void require_symmetric(const std::filesystem::path& path, const Sparse& m) {
  const Sparse transposed = m.transpose(), difference = m - transposed;
  const double largest = m.nonZeros() > 0 ? m.coeffs().abs().maxCoeff() : 0.0;
  for (Eigen::Index j = 0; j < difference.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(difference, j); entry; ++entry) {
      if (!(std::abs(entry.value()) > symmetric_to * largest)) continue;
      refuse_file(path, "element (" + std::to_string(entry.row() + 1) + ", " + std::to_string(j + 1) + ")",
                  "the matrix is not symmetric", "mass, damping and stiffness are");
    }
  }
}

FileMatrix read_any(const std::filesystem::path& path, const std::string& variable) {
  require_regular_file(path);
  std::ifstream in(path);
  if (!in) refuse_file(path, "", "it cannot be read");
  std::string first;
  std::getline(in, first);
  if (first.starts_with("%%")) return MarketReader(path).read();
  if (is_op4(path)) return read_op4(path, variable);
  if (is_dmig(path)) return read_dmig(path, variable);
  if (is_abaqus_matrix(path)) return read_abaqus_matrix(path);
  if (path.extension() == ".mtx") return MarketReader(path).read();
  if (const auto file = frf::open_variables(path)) return read_variable_matrix(*file, variable);
  return from_text(path, variable);
}

}  // namespace

FileMatrix read_file_matrix(const std::filesystem::path& path, const std::string& variable) {
  FileMatrix out = read_any(path, variable);
  for (Sparse* m : {&out.real, &out.imaginary}) {
    if (m->rows() == 0) continue;
    require_symmetric(path, *m);
    const Sparse transposed = m->transpose();
    *m = 0.5 * (*m + transposed);
  }
  return out;
}

Eigen::SparseMatrix<double> read_symmetric_sparse(const std::filesystem::path& path, const std::string& variable) {
  const FileMatrix read = read_file_matrix(path, variable);
  if (read.imaginary.nonZeros() > 0) refuse_file(path, variable, "the matrix is complex", "give a real one");
  return read.real;
}

Eigen::MatrixXd read_symmetric_matrix(const std::filesystem::path& path, const std::string& variable) {
  const Sparse m = read_symmetric_sparse(path, variable);
  if (static_cast<double>(m.rows()) > most_rows) refuse_file(path, variable, "the matrix has more than 20000 rows");
  return m;
}

}  // namespace jointid::models
