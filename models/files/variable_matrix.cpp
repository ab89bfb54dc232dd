#include "models/files/variable_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/file/unit_suffix.hpp"
#include "frf/mat/mat_column.hpp"
#include "frf/set/unit_label.hpp"
#include "models/files/failure.hpp"

namespace jointid::models {
namespace {

using frf::MatInfo;
using frf::MatKind;

constexpr std::size_t most_full_rows = 20000;
constexpr auto to_columns = "write it as compressed columns, in Python by tocsc()";

/// The arrays of a way to store a sparse matrix, the one that no other has first.
struct SparseWay {
  std::array<std::string, 3> parts;
  bool compressed;
};

const std::array<SparseWay, 3>& sparse_ways() {
  static const std::array<SparseWay, 3> ways = {
      {{{"jc", "ir", "data"}, true}, {{"indptr", "indices", "data"}, true}, {{"col", "row", "data"}, false}}};
  return ways;
}

bool is_number(const MatInfo& info) { return info.kind == MatKind::real || info.kind == MatKind::complex; }

/// A square matrix of more than one number.
bool is_full_matrix(const MatInfo& info) {
  return is_number(info) && info.dims.size() == 2 && info.dims[0] == info.dims[1] && info.dims[0] > 1;
}

/// Reads the matrices of one file.
class MatrixReader {
 public:
  explicit MatrixReader(frf::MatFile& file) : file_(file) {
    for (const MatInfo& info : file.variables()) {
      for (const SparseWay& way : sparse_ways()) {
        const std::string& part = way.parts.front();
        if (info.name == part && has(way.parts[1])) sparse_.emplace("", &way);
        if (info.name.ends_with("." + part)) sparse_.emplace(info.name.substr(0, info.name.size() - part.size() - 1), &way);
      }
    }
  }

  FileMatrix read(const std::string& variable) {
    require_known_format();
    const std::vector<std::string> names = matrices();
    name_ = variable;
    if (variable.empty()) {
      if (names.empty()) fail("it holds no square matrix; there are " + comma_list(file_.variables(), &MatInfo::name), "");
      if (names.size() > 1)
        refuse_file(file_.file(), "", "the file holds several matrices: " + comma_list(names),
                    "name one: \"" + std::filesystem::path(file_.file()).filename().string() + ":NAME\"");
      name_ = names.front();
    }
    FileMatrix out = matrix(variable, names);
    out.stated_unit = stated_unit();
    return out;
  }

 private:
  FileMatrix matrix(const std::string& variable, const std::vector<std::string>& names) {
    if (const auto found = sparse_.find(name_); found != sparse_.end()) return sparse(*found->second);
    const auto found = std::ranges::find(file_.variables(), name_, &MatInfo::name);
    if (found == file_.variables().end() || !is_number(*found))
      refuse_file(file_.file(), variable, "there is no such matrix; there are: " + comma_list(names));
    return full(*found);
  }

  /// One other than SI, of the matrix or of the file, or in the name: "K_N_mm".
  std::string stated_unit() const {
    const frf::ColumnUnits units(file_);
    frf::Columns remarks;
    for (auto& [name, text] : units.unread()) remarks.remarks.push_back({name, name + ": " + text});
    const auto unread = frf::unread_unit(remarks, [](const frf::Unit&) { return true; });
    if (unread) return "the unit '" + unread->unit + "' in " + unread->place;
    const auto found = std::ranges::find(file_.variables(), name_, &MatInfo::name);
    std::string label = found == file_.variables().end() ? std::string() : units.of(*found).front();
    if (label.empty()) label = frf::stiffness_or_mass_suffix(name_);
    const auto unit = frf::parse_unit(label);
    return unit && unit->si != 1.0 ? "the unit '" + label + "' of " + name_ : std::string();
  }

  bool has(const std::string& name) const {
    return std::ranges::find(file_.variables(), name, &MatInfo::name) != file_.variables().end();
  }

  [[noreturn]] void fail(std::string problem, std::string remedy = "write it again") const {
    refuse_file(file_.file(), name_.empty() ? "" : "variable " + name_, std::move(problem), std::move(remedy));
  }

  /// Of scipy.sparse.save_npz().
  void require_known_format() {
    const auto format = std::ranges::find(file_.variables(), "format", &MatInfo::name);
    if (format == file_.variables().end() || format->kind != MatKind::text || !has("shape") || !has("data")) return;
    const std::vector<std::string> words = file_.read(*format).texts;
    constexpr std::array known = {"csc", "csr", "coo"};
    if (words.size() == 1 && std::ranges::find(known, words.front()) == known.end())
      fail("a matrix in the format " + words.front() + " of scipy is not read", to_columns);
  }

  std::vector<std::string> matrices() const {
    std::vector<std::string> names;
    for (const auto& [name, way] : sparse_) names.push_back(name);
    for (const MatInfo& info : file_.variables()) {
      if (is_full_matrix(info)) names.push_back(info.name);
    }
    if (!names.empty()) return names;
    for (const MatInfo& info : file_.variables()) {
      const bool one = std::ranges::all_of(info.dims, [](std::size_t extent) { return extent == 1; });
      if (is_number(info) && one) names.push_back(info.name);
    }
    return names;
  }

  FileMatrix full(const MatInfo& info) {
    const std::size_t rows = info.dims.empty() ? 1 : info.dims[0], columns = info.dims.size() < 2 ? 1 : info.dims[1];
    if (info.dims.size() > 2 || rows != columns)
      fail("the matrix is not square: " + std::to_string(rows) + " × " + std::to_string(columns), "");
    if (rows > most_full_rows)
      fail("the matrix has more than " + std::to_string(most_full_rows) + " rows", "store it as a sparse one");
    const frf::MatVariable read = file_.read(info);
    for (std::size_t k = 0; k < read.values.size(); ++k) require_finite(read.values[k], k);
    const Eigen::Map<const Eigen::MatrixXcd> all(read.values.data(), at(rows), at(rows));
    FileMatrix out{Eigen::SparseMatrix<double>(all.real().sparseView()), {}, {}};
    if (!all.imag().isZero(0.0)) out.imaginary = all.imag().sparseView();
    return out;
  }

  void require_finite(Complex value, std::size_t k) const {
    if (!std::isfinite(value.real()) || !std::isfinite(value.imag()))
      fail("element " + std::to_string(k + 1) + " is no finite number");
  }

  /// Of an array of the sparse matrix.
  std::string array_name(const std::string& part) const { return name_.empty() ? part : name_ + "." + part; }

  std::vector<Complex> numbers(const std::string& part) {
    const auto found = std::ranges::find(file_.variables(), array_name(part), &MatInfo::name);
    if (found == file_.variables().end() || !(is_number(*found) || found->kind == MatKind::sparse))
      fail("it is a sparse matrix without numbers " + part);
    return file_.read(*found).values;
  }

  /// Numbers of places, stored as doubles or integers.
  std::vector<std::size_t> places(const std::string& part) {
    std::vector<std::size_t> out;
    for (const Complex value : numbers(part)) {
      if (!(value.real() >= 0.0 && value.real() < 4e9) || value.real() != std::floor(value.real()))
        fail(std::to_string(value.real()) + " is no place in a sparse matrix");
      out.push_back(static_cast<std::size_t>(value.real()));
    }
    return out;
  }

  FileMatrix sparse(const SparseWay& way) {
    const std::vector<std::size_t> columns = places(way.parts[0]);
    if (way.compressed) require_rows_of_matlab(way, columns.size());
    if (is_without_elements(way, columns)) return from_compressed(columns, {}, {});
    const std::vector<std::size_t> rows = places(way.parts[1]);
    const std::vector<Complex> data = numbers(way.parts[2]);
    if (way.compressed && has(array_name("shape"))) require_square();
    return way.compressed ? from_compressed(columns, rows, data) : from_places(columns, rows, data);
  }

  /// MATLAB v7.3 states the rows in an attribute of the group.
  void require_rows_of_matlab(const SparseWay& way, std::size_t begins) {
    const auto first = std::ranges::find(file_.variables(), array_name(way.parts.front()), &MatInfo::name);
    for (const auto& [place, text] : file_.notes(*first)) {
      if (!place.ends_with("@MATLAB_sparse")) continue;
      if (text != std::to_string(begins - 1)) fail("the matrix is not square: " + text + " × " + std::to_string(begins - 1), "");
      return;
    }
  }

  /// Of a matrix of zeros MATLAB v7.3 writes where columns begin, and nothing else.
  bool is_without_elements(const SparseWay& way, const std::vector<std::size_t>& begins) const {
    return way.compressed && !has(array_name(way.parts[1])) && !has(array_name(way.parts[2])) &&
           std::ranges::all_of(begins, [](std::size_t begin) { return begin == 0; });
  }

  /// Its rows.
  std::size_t require_square() {
    const std::vector<std::size_t> shape = places("shape");
    if (shape.size() != 2) fail("its shape has " + std::to_string(shape.size()) + " numbers");
    if (shape[0] != shape[1])
      fail("the matrix is not square: " + std::to_string(shape[0]) + " × " + std::to_string(shape[1]), "");
    return shape[0];
  }

  void require_rows(std::size_t n) const {
    if (n < 1 || n > most_sparse_rows) fail("it has no columns, or more than " + std::to_string(most_sparse_rows), "");
  }

  using Places = std::vector<std::size_t>;

  FileMatrix from_compressed(const Places& begins, const Places& rows, const std::vector<Complex>& data) {
    require_rows(begins.empty() ? 0 : begins.size() - 1);
    if (begins.back() > data.size() || begins.back() > rows.size()) fail("it has fewer elements than its columns state");
    if (data.size() > rows.size()) fail("its elements are blocks", to_columns);
    const std::size_t n = begins.size() - 1;
    FileElements elements(file_.file());
    for (std::size_t j = 0; j < n; ++j) {
      if (begins[j] > begins[j + 1]) fail("column " + std::to_string(j + 1) + " ends before it begins");
      for (std::size_t k = begins[j]; k < begins[j + 1]; ++k) {
        require_finite(data[k], k);
        if (rows[k] >= n)
          fail("row " + std::to_string(rows[k] + 1) + " of a matrix of " + std::to_string(n) + " columns, which is to be square");
        elements.add(rows[k], j, data[k].real(), data[k].imag());
      }
    }
    return elements.matrix(n, FileElements::Mirror::none);
  }

  FileMatrix from_places(const Places& columns, const Places& rows, const std::vector<Complex>& data) {
    if (columns.size() != data.size() || rows.size() != data.size()) fail("its elements, rows and columns are not equally many");
    const std::size_t n = require_square();
    require_rows(n);
    std::map<std::pair<std::size_t, std::size_t>, Complex> sums;
    for (std::size_t k = 0; k < data.size(); ++k) {
      require_finite(data[k], k);
      if (rows[k] >= n || columns[k] >= n)
        fail("element " + std::to_string(k + 1) + " is beyond the " + std::to_string(n) + " rows and columns");
      sums[{columns[k], rows[k]}] += data[k];
    }
    FileElements elements(file_.file());
    for (const auto& [place, value] : sums) elements.add(place.second, place.first, value.real(), value.imag());
    return elements.matrix(n, FileElements::Mirror::none);
  }

  frf::MatFile& file_;
  std::map<std::string, const SparseWay*> sparse_;  ///< by the name of the matrix
  std::string name_;
};

}  // namespace

FileMatrix read_variable_matrix(frf::MatFile& file, const std::string& variable) { return MatrixReader(file).read(variable); }

}  // namespace jointid::models
