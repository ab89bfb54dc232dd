#include "models/matrix_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <vector>

#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/file/columns.hpp"
#include "models/failure.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr double most_rows = 20000.0;  ///< of full matrices
constexpr double most_sparse_rows = 2000000.0;
constexpr double symmetric_to = 1e-9;  ///< of the largest element

/// Reads a Matrix Market file line by line, comments left out.
class MarketReader {
 public:
  explicit MarketReader(const std::filesystem::path& path) : path_(path) {
    require_regular_file(path);
    in_.open(path);
    if (!in_) refuse_file(path_, "", "it cannot be read");
  }

  Sparse read() {
    std::string line;
    std::getline(in_, line);
    number_ = 1;
    std::istringstream head(line);
    std::string banner, object, format, field, symmetry;
    head >> banner >> object >> format >> field >> symmetry;
    for (std::string* word : {&object, &format, &field, &symmetry}) std::ranges::transform(*word, word->begin(), ::tolower);
    if (banner != "%%MatrixMarket" || object != "matrix") fail("the first line is not that of a Matrix Market matrix");
    if (field != "real" && field != "integer") fail("the matrix is " + field, "give a real one");
    if (symmetry != "general" && symmetry != "symmetric") fail("the matrix is " + symmetry, "give a symmetric or general one");
    symmetric_ = symmetry == "symmetric";
    if (format == "coordinate") return coordinates();
    if (format == "array") return array();
    fail("format '" + format + "' is unknown", "use coordinate or array");
  }

 private:
  [[noreturn]] void fail(std::string problem, std::string remedy = {}) const {
    refuse_file(path_, "line " + std::to_string(number_), std::move(problem), std::move(remedy));
  }

  std::vector<double> numbers(std::size_t count) {
    std::string line;
    do {
      if (!std::getline(in_, line)) fail("the file ends early");
      ++number_;
    } while (line.empty() || line[0] == '%' || line.find_first_not_of(" \t\r") == std::string::npos);
    std::istringstream text(line);
    std::vector<double> found(count);
    for (double& value : found) {
      if (!(text >> value) || !std::isfinite(value)) fail("'" + line + "' is not " + std::to_string(count) + " numbers");
    }
    return found;
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

  void add(Eigen::Index i, Eigen::Index j, double value) {
    entries_.emplace_back(i, j, value);
    if (symmetric_ && i != j) entries_.emplace_back(j, i, value);
  }

  Sparse matrix() const {
    Sparse m(rows_, rows_);
    m.setFromTriplets(entries_.begin(), entries_.end());
    return m;
  }

  Sparse coordinates() {
    const std::vector<double> size = numbers(3);
    begin(size[0], size[1], most_sparse_rows);
    for (double i = 0.0; i < size[2]; ++i) {
      const std::vector<double> entry = numbers(3);
      add(index(entry[0], rows_), index(entry[1], rows_), entry[2]);
    }
    return matrix();
  }

  Sparse array() {
    const std::vector<double> size = numbers(2);
    begin(size[0], size[1], most_rows);
    for (Eigen::Index j = 0; j < rows_; ++j) {
      for (Eigen::Index i = symmetric_ ? j : 0; i < rows_; ++i) add(i, j, numbers(1)[0]);
    }
    return matrix();
  }

  const std::filesystem::path& path_;
  std::ifstream in_;
  std::size_t number_ = 0;
  bool symmetric_ = false;
  Eigen::Index rows_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// Columns "NAME(1)", "NAME(2)", … of one matrix, or "1", "2", … of a text.
Eigen::MatrixXd from_columns(const std::filesystem::path& path, const std::string& variable) {
  std::map<std::string, std::vector<const std::vector<double>*>> matrices;
  const frf::Columns read = frf::read_columns(path);
  for (const frf::NumberColumn& column : read.columns) {
    const std::size_t bracket = column.name.rfind('(');
    const bool plain = std::ranges::all_of(column.name, [](unsigned char c) { return std::isdigit(c) != 0; });
    matrices[plain ? "" : column.name.substr(0, bracket)].push_back(&column.values);
  }
  const std::string names = comma_list(matrices, [](const auto& named) { return named.first.empty() ? "rows of numbers" : named.first; });
  const auto found = variable.empty() && matrices.size() == 1 ? matrices.begin() : matrices.find(variable);
  if (found == matrices.end()) {
    refuse_file(path, variable,
                variable.empty() ? "the file holds several matrices: " + names : "there is no such matrix; there are: " + names,
                variable.empty() ? "name one: \"" + path.filename().string() + ":NAME\"" : "");
  }
  const std::size_t size = found->second.size();
  Eigen::MatrixXd m(at(size), at(size));
  for (std::size_t j = 0; j < size; ++j) {
    if (found->second[j]->size() != size) {
      refuse_file(path, variable,
                  "the matrix is not square: " + std::to_string(found->second[j]->size()) + " × " + std::to_string(size));
    }
    for (std::size_t i = 0; i < size; ++i) m(at(i), at(j)) = (*found->second[j])[i];
  }
  return m;
}

}  // namespace

Eigen::SparseMatrix<double> read_symmetric_sparse(const std::filesystem::path& path, const std::string& variable) {
  const Sparse m = path.extension() == ".mtx" ? MarketReader(path).read() : Sparse(from_columns(path, variable).sparseView());
  const Sparse transposed = m.transpose(), difference = m - transposed;
  const double largest = m.nonZeros() > 0 ? m.coeffs().abs().maxCoeff() : 0.0;
  for (Eigen::Index j = 0; j < difference.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(difference, j); entry; ++entry) {
      if (!(std::abs(entry.value()) > symmetric_to * largest)) continue;
      refuse_file(path, "element (" + std::to_string(entry.row() + 1) + ", " + std::to_string(j + 1) + ")",
                  "the matrix is not symmetric", "mass, damping and stiffness are");
    }
  }
  return 0.5 * (m + transposed);
}

Eigen::MatrixXd read_symmetric_matrix(const std::filesystem::path& path, const std::string& variable) {
  const Sparse m = read_symmetric_sparse(path, variable);
  if (static_cast<double>(m.rows()) > most_rows) refuse_file(path, variable, "the matrix has more than 20000 rows");
  return m;
}

}  // namespace jointid::models
