#include "models/matrix_file.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <vector>

#include "base/eigen.hpp"
#include "base/temporary_file.hpp"
#include "base/text.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_format.hpp"
#include "frf/mat/mat_variable.hpp"
#include "models/failure.hpp"
#include "models/labelled_matrix.hpp"
#include "models/nastran_op4.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

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

  FileMatrix matrix() const {
    FileMatrix out{Sparse(rows_, rows_), {}, {}};
    out.real.setFromTriplets(entries_.begin(), entries_.end());
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
};

/// A sparse matrix in compressed columns, counted from 0.
struct CompressedColumns {
  std::vector<Complex> data;
  std::vector<std::size_t> rows, begins;  ///< of each element; of each column, and the end of the last
};

/// The elements of compressed columns.
FileMatrix from_compressed(const std::filesystem::path& path, const std::string& name, const CompressedColumns& sparse) {
  const auto fail = [&](const std::string& problem) { refuse_file(path, "variable " + name, problem, "write it again"); };
  const auto& [data, rows, begins] = sparse;
  if (begins.size() < 2 || begins.size() - 1 > most_sparse_rows) fail("it has no columns, or more than 2000000");
  if (begins.back() > data.size() || begins.back() > rows.size()) fail("it has fewer elements than its columns state");
  const std::size_t n = begins.size() - 1;
  FileElements elements(path);
  for (std::size_t j = 0; j < n; ++j) {
    if (begins[j] > begins[j + 1]) fail("column " + std::to_string(j + 1) + " ends before it begins");
    for (std::size_t k = begins[j]; k < begins[j + 1]; ++k) {
      if (!std::isfinite(data[k].real()) || !std::isfinite(data[k].imag()))
        fail("element " + std::to_string(k + 1) + " is no finite number");
      if (rows[k] >= n)
        fail("row " + std::to_string(rows[k] + 1) + " of a matrix of " + std::to_string(n) + " columns, which is to be square");
      elements.add(rows[k], j, data[k].real(), data[k].imag());
    }
  }
  return elements.matrix(n, FileElements::Mirror::none);
}

/// Numbers of places as MATLAB and others store them, as doubles or integers.
std::vector<std::size_t> places(const std::filesystem::path& path, const std::string& name, const std::vector<Complex>& values) {
  std::vector<std::size_t> out;
  for (const Complex value : values) {
    if (!(value.real() >= 0.0 && value.real() < 4e9) || value.real() != std::floor(value.real()))
      refuse_file(path, "variable " + name, std::to_string(value.real()) + " is no place in a sparse matrix", "write it again");
    out.push_back(static_cast<std::size_t>(value.real()));
  }
  return out;
}

/// Columns "NAME(1)", "NAME(2)", … of one matrix, or "1", "2", … of a text.
Eigen::MatrixXd from_columns(const std::filesystem::path& path, const std::string& variable) {
  std::map<std::string, std::vector<const std::vector<double>*>> matrices;
  const frf::Columns read = frf::read_columns(path);
  for (const frf::NumberColumn& column : read.columns) {
    const std::size_t bracket = column.name.rfind('(');
    const bool plain = std::ranges::all_of(column.name, [](unsigned char c) { return std::isdigit(c) != 0; });
    matrices[plain ? "" : column.name.substr(0, bracket)].push_back(&column.values);
  }
  const std::string names =
      comma_list(matrices, [](const auto& named) { return named.first.empty() ? "rows of numbers" : named.first; });
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

/// Names of the sparse matrices of a file: groups whose datasets are data with ir and jc (MATLAB
/// v7.3), or with indices and indptr (scipy).
std::vector<std::string> sparse_names(const frf::MatFile& file) {
  std::vector<std::string> names;
  for (const frf::MatInfo& info : file.variables()) {
    for (const std::string ending : {".jc", ".indptr"}) {
      if (info.name.ends_with(ending)) names.push_back(info.name.substr(0, info.name.size() - ending.size()));
    }
  }
  return names;
}

CompressedColumns read_sparse_variable(const std::filesystem::path& path, frf::MatFile& file, const std::string& name) {
  const auto find = [&](const std::string& of) { return std::ranges::find(file.variables(), of, &frf::MatInfo::name); };
  const bool of_matlab = find(name + ".jc") != file.variables().end();
  std::vector<std::vector<Complex>> parts;
  for (const std::string part : {"data", of_matlab ? "ir" : "indices", of_matlab ? "jc" : "indptr"}) {
    const auto found = find(name + "." + part);
    const bool is_number =
        found != file.variables().end() && (found->kind == frf::MatKind::real || found->kind == frf::MatKind::complex);
    if (!is_number) refuse_file(path, "variable " + name, "it is a sparse matrix without numbers " + part, "write it again");
    parts.push_back(file.read(*found).values);
  }
  return {parts[0], places(path, name, parts[1]), places(path, name, parts[2])};
}

/// Nothing where the file has no sparse matrix of that name.
std::optional<FileMatrix> from_sparse_variable(const std::filesystem::path& path, const std::string& variable) {
  const auto binary = frf::detect_binary_format(path);
  if (!binary || (*binary != frf::FileFormat::matlab_v73 && *binary != frf::FileFormat::jointid_hdf5)) return std::nullopt;
  const auto file = frf::open_mat_variables_v73(path);
  const std::vector<std::string> names = sparse_names(*file);
  if (names.empty() || (!variable.empty() && std::ranges::find(names, variable) == names.end())) return std::nullopt;
  if (variable.empty() && names.size() > 1) {
    refuse_file(path, "", "the file holds several matrices: " + comma_list(names),
                "name one: \"" + path.filename().string() + ":NAME\"");
  }
  const std::string name = variable.empty() ? names.front() : variable;
  return from_compressed(path, name, read_sparse_variable(path, *file, name));
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
  if (auto sparse = from_sparse_variable(path, variable)) return std::move(*sparse);
  return {Sparse(from_columns(path, variable).sparseView()), {}, {}};
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
