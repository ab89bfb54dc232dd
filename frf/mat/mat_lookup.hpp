#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// "variable H" and "3x2", as messages say it.
std::string place_of(std::string_view variable);
std::string shape(const MatInfo& info);
std::size_t size(const MatInfo& info);

/// Whatever the case, but for single letters: f is a frequency and F may be a force.
bool same_name(std::string_view a, std::string_view b);

/// "S.inner." of S.inner.field; empty of a variable that is no field.
std::string scope_of(const MatInfo& info);

/// "H [296x7], f [296x1]", as the program that wrote the file shows them.
std::string listed(const MatFile& file, const std::vector<const MatInfo*>& infos);

/// Finds variables by the conventions of mat_file.hpp, from a struct outwards: among its fields, those of the struct around it, …
/// and the variables of the file.
class MatLookup {
 public:
  /// `scope`: as scope_of() says it.
  MatLookup(MatFile& file, const std::string& scope);

  /// The first of these names that there is in the innermost scope that has one, or null.
  const MatInfo* find(std::span<const std::string_view> names) const;
  const MatInfo* find(std::string_view name) const { return find(std::span(&name, 1)); }

  /// The frequencies, Hz: of `variable` when given, else by name, else of the fields start_value, increment and number_of_values
  /// of x_values. A `unit` that is given stands in place of the file's. Throws InputError listing what may be them when there are
  /// none.
  std::vector<double> axis(const std::string& variable, const std::string& unit, const MatInfo& frf) const;

  /// Whether a variable is a vector of frequencies by its name, or by a unit beside it.
  bool is_axis(const std::string& variable) const;

  /// How many there are, or 0 where they are not found.
  std::size_t axis_length(const std::string& variable) const;

  /// The first text of a variable; empty where there is none, or "-" or NONE stands there. Throws InputError where it is no text.
  std::string text(std::span<const std::string_view> names) const;

  /// All texts of a variable with commas between them; empty where there is none that is text.
  std::string joined_text(std::span<const std::string_view> names) const;

  /// One real number of a variable, or NaN.
  double number(std::string_view name) const;

  /// DOFs of a variable with one of these names, or of two with numbers of nodes and directions. `given` are those of the user:
  /// they are taken where the file has none. Throws InputError where the file names others.
  /// `scale`: the variable along the axis of the array (MatFile::scales()), which is taken where no other is.
  std::vector<Dof> dofs(bool response, const std::vector<Dof>& given, const std::string& scale) const;

  /// Throws InputError (data) about the file.
  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const;

 private:
  const MatInfo* of_scope(const std::string& scope, std::string_view name) const;
  std::vector<double> numbers(const MatInfo& info) const;
  const MatInfo* axis_by_name() const;
  const MatInfo* axis_by_words() const;
  const MatInfo& named_axis(const std::string& variable) const;
  double hz_per_unit(const MatInfo& axis) const;
  void require_no_other_label(const MatInfo& axis, double by_name) const;
  std::vector<double> stepped_axis(const std::string& unit) const;
  [[noreturn]] void fail_axis(const MatInfo& frf) const;
  std::vector<std::string> texts(const MatInfo& info) const;
  std::vector<std::string> nodes_and_directions(bool response) const;

  MatFile& file_;
  std::vector<std::string> scopes_;  ///< innermost first, last the empty one of the file
};

}  // namespace jointid::frf
