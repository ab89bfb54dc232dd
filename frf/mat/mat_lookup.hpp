#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// "variable H" and "3x2", as messages say it.
std::string place_of(std::string_view variable);
std::string shape(const MatInfo& info);
std::size_t size(const MatInfo& info);

/// Finds variables by the conventions of mat_file.hpp.
class MatLookup {
 public:
  explicit MatLookup(MatFile& file) : file_(file) {}

  /// By name, whatever its case (but for single letters), or null.
  const MatInfo* find(std::string_view name) const;

  /// The frequencies, Hz. Throws InputError listing all variables when there are none.
  std::vector<double> axis() const;

  /// The FRFs: `variable` when given, else `frf`, else the only complex array with an axis of `lines`.
  /// Throws InputError listing the candidates.
  const MatInfo& frf(const std::string& variable, std::size_t lines) const;

  /// First text of a variable, or empty.
  std::string text(const char* name) const;

  /// DOFs of a variable, or `otherwise` when there is none.
  std::vector<Dof> dofs(const char* name, const std::vector<Dof>& otherwise) const;

  /// Throws InputError (data) about the file.
  [[noreturn]] void fail(std::string place, std::string problem, std::string remedy) const;

 private:
  std::string all() const;
  const MatInfo& named_frf(const std::string& name) const;

  MatFile& file_;
};

}  // namespace jointid::frf
