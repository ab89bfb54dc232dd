#pragma once

#include <vector>

#include "ident/likelihood/line/line_layout.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// Σ_k (δY g_k)ᴴ T_k (δY g_k) as a quadratic form in the elements of Y that a line has, δY symmetric and zero elsewhere: normal
/// equations of rows that touch Y through g_k alone. The blocks conj(g_k(i)) g_k(j) T_k of all k are one matrix product, over
/// pairs of columns (i, j) of Y by the rows of both. O(K N⁴), where the rows themselves cost O(K N⁵).
class KroneckerSquares {
 public:
  explicit KroneckerSquares(const LineLayout& layout);

  /// N×N squares for so many vectors; add_to() takes those that were put.
  void reset(std::size_t most);

  /// T, Hermitian, and its g.
  void put(const Eigen::Ref<const ComplexMatrix>& t, const Eigen::Ref<const Eigen::VectorXcd>& g);

  /// The lower triangle of `normal` gets the form.
  void add_to(ComplexMatrix& normal);

 private:
  /// Columns of Y that have the same rows.
  struct Group {
    std::vector<std::size_t> columns, rows;
  };

  void add_pairs(const Group& one, const Group& other, ComplexMatrix& normal);

  std::size_t joint_;
  std::vector<Group> groups_;
  std::vector<Eigen::Index> place_;  ///< [N·N] of (row, column) and (column, row) in Y
  ComplexMatrix squares_, vectors_;  ///< N²×K, N×K
  Eigen::Index used_ = 0;            ///< K
  ComplexMatrix blocks_, factors_, products_;
};

}  // namespace jointid::ident
