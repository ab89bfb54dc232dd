#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// The name of column k of a real vector or matrix: NAME of a vector, NAME(k + 1) of a matrix.
std::string column_name(const MatInfo& info, std::size_t k);

/// Whether a variable is real numbers in columns: a vector or matrix, none of an array of structs.
bool is_column(const MatInfo& info);

/// How many columns a vector or matrix has: its shorter axis.
std::size_t columns_of(const MatInfo& info);

/// What a file states of the units of its variables.
class ColumnUnits {
 public:
  /// `file` must outlive it.
  explicit ColumnUnits(MatFile& file);

  /// One for each column of a real vector or matrix, empty where nothing is stated: an attribute unit or units of an HDF5
  /// dataset, one or one for each column ("N, g"); a text NAME_unit, NAME_units or units.NAME; of fields NAME.values, NAME.value,
  /// NAME.data or NAME.y a text NAME.unit or NAME.units; as many texts unit or units as a matrix, the only one of that size
  /// beside them, has columns; of x and y the texts xunit, x_unit and xlabel ("Time [ms]") beside them. Case does not matter.
  /// Throws InputError where a text cannot be read.
  std::vector<std::string> of(const MatInfo& info) const;

  /// Texts and attributes by the name of a unit, a label or a sensitivity that were of no column yet: their names and the texts.
  std::vector<std::pair<std::string, std::string>> unread() const;

 private:
  std::vector<std::string> texts(const std::string& name) const;
  /// The same texts, which are not unread any more.
  std::vector<std::string> used(const std::string& name, std::vector<std::string> texts) const;
  std::string of_axis(const std::string& scope, char axis) const;

  MatFile& file_;
  mutable std::set<std::string> used_;                                ///< names of texts in lower case
  std::map<std::string, const MatInfo*> texts_;                       ///< by name in lower case
  std::map<std::pair<std::string, std::size_t>, std::size_t> alike_;  ///< matrices of a struct by their number of columns
};

}  // namespace jointid::frf
