#pragma once

#include <vector>

#include "minimise/linear/correlation.hpp"

namespace jointid::ident {

/// Rows of the linearised line whose errors depend on each other: Z of each group, whitened, L⁻¹ Z, adds to the normal equations what
/// independent rows add one by one. A row is that of an element weighted as Correlation weights its error: for every column
/// Re w Re z + i Im w Im z.
class CorrelatedRows {
 public:
  /// Zero, for rows of `columns` numbers.
  void reset(const minimise::Correlation& correlation, std::size_t columns);

  /// Row of an element of some group, to be written to.
  Complex* row(minimise::Correlation::Place place) {
    return groups_[place.group].col(static_cast<Eigen::Index>(place.row)).data();
  }

  /// Adds Re(Zᴴ ρ⁻¹ Z), the lower triangle: columns are real unknowns.
  void add_to(Eigen::Ref<Eigen::MatrixXd> normal) const;

  /// Adds Zᴴ ρ⁻¹ Z, the lower triangle: columns are complex unknowns. Only of circular errors.
  void add_to(Eigen::MatrixXcd& normal) const;

 private:
  const minimise::Correlation* correlation_ = nullptr;
  std::vector<Eigen::MatrixXcd> groups_;  ///< Zᵀ, [columns, elements]
};

}  // namespace jointid::ident
