#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// What a variable of a MATLAB file holds, as far as FRFs are made of it.
/// `sparse`: an array of a sparse matrix (its elements, rows, columns or shape); dims say how many numbers it has at most, its
/// content how many there are. Such an array is of a matrix, and never a channel, an axis or FRFs.
enum class MatKind : std::uint8_t { real, complex, sparse, text, other };

struct MatInfo {
  std::string name;  ///< of a field of a struct: S.field, S.inner.field, of an array of structs S(2).field; so are datasets in
                     ///< groups of HDF5
  MatKind kind = MatKind::other;  ///< a cell array counts as text until it is read
  std::vector<std::size_t> dims;  ///< as MATLAB shows them
  std::string unit{};             ///< the attribute unit or units of an HDF5 dataset, or empty
  bool integers = false;          ///< of a type without fractions
};

/// A variable with its content, numbers in MATLAB's order (first index fastest).
struct MatVariable {
  MatInfo info;
  std::vector<Complex> values;     ///< real or complex
  std::vector<std::string> texts;  ///< rows of a character array, or cells
};

/// An open file of named arrays: MATLAB of some version, other HDF5, arrays of numpy.
class MatFile {
 public:
  virtual ~MatFile() = default;
  MatFile(const MatFile&) = delete;
  MatFile& operator=(const MatFile&) = delete;

  const std::string& file() const { return file_; }
  const std::vector<MatInfo>& variables() const { return variables_; }
  /// The same by their names in lower case, those of one name in the order of the file; until another variable is added.
  const std::multimap<std::string, const MatInfo*>& by_lower_name() const;

  /// Reads one of `variables`: as many numbers as its size says, of a sparse matrix what is there. Throws InputError when the
  /// file breaks its promises.
  MatVariable read(const MatInfo& info);

  /// Whether the program that wrote the file counts the last index fastest (C, numpy): `dims` and numbers of a variable then are
  /// in MATLAB's order of the transposed array.
  virtual bool last_index_fastest() const { return false; }

  /// A text that stands beside a variable (null: beside all of them), an attribute of HDF5, whatever the case of its name; else
  /// empty.
  virtual std::string note(const MatInfo* info, std::string_view name);

  /// All such texts of a variable, of the groups it is in and of the file, by their names behind the place and an @.
  virtual std::vector<std::pair<std::string, std::string>> notes(const MatInfo& info);

  /// The variables along the axes of an array (dimension scales of HDF5), in the order of its axes as the program that wrote it
  /// shows them; an empty name where an axis has none, nothing where no axis has one.
  virtual std::vector<std::string> scales(const MatInfo& info);

  /// Whether read_samples() reads parts of a variable from the file.
  virtual bool reads_samples() const { return false; }
  /// Samples [first, first + count) of a real vector or matrix, whose longer axis (the first of equal ones) counts the samples:
  /// [count, others], the others of one sample together.
  virtual std::vector<double> read_samples(const MatInfo& info, std::size_t first, std::size_t count);

 protected:
  explicit MatFile(std::string file) : file_(std::move(file)) {}
  [[noreturn]] void fail(const std::string& variable, std::string problem, std::string remedy = {}) const;
  /// Of `variables`, which are read by their names. Throws InputError.
  void require_distinct_names() const;

  std::string file_;
  std::vector<MatInfo> variables_;

 private:
  virtual MatVariable read_variable(const MatInfo& info) = 0;

  mutable std::multimap<std::string, const MatInfo*> by_lower_name_;  ///< made when it is asked for
};

/// By matio (v5, v6, v7; a build without it throws InputError that says so), or v4 by itself.
std::unique_ptr<MatFile> open_mat_variables_v5(const std::filesystem::path& path);

/// By HDF5 (v7.3).
std::unique_ptr<MatFile> open_mat_variables_v73(const std::filesystem::path& path);

}  // namespace jointid::frf
