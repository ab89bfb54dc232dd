#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "ident/likelihood/line/line_state.hpp"

namespace jointid::ident {

/// A real unknown that acts by a complex column times a number of its own.
struct SharedColumn {
  Eigen::Index column;
  Complex factor;
};

/// U⁻¹W of a line [2v×p]: by how much its FRFs change with the unknowns. Unknowns that act by the same matrix, as stiffness and damping
/// of one spring do, share a column.
class WayBack {
 public:
  explicit WayBack(Eigen::MatrixXd all) : all_(std::move(all)) {}

  /// Unknown i is factor_i · column_i of `columns` [v×any].
  WayBack(Eigen::MatrixXcd columns, std::vector<SharedColumn> unknowns) : columns_(std::move(columns)), unknowns_(std::move(unknowns)) {}

  LineStep times(const Eigen::VectorXd& step) const;
  Eigen::VectorXd transpose_times(const LineStep& own) const;
  Eigen::MatrixXd matrix() const;
  std::size_t numbers() const { return static_cast<std::size_t>(all_.size() + 2 * columns_.size()); }

 private:
  Eigen::MatrixXd all_;
  Eigen::MatrixXcd columns_;
  std::vector<SharedColumn> unknowns_;
};

}  // namespace jointid::ident
