#pragma once

#include <vector>

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_factors.hpp"

namespace jointid::ident {

/// Pᴴ W² P of rows of P, Hermitian; W their weights, rows without are left out.
struct WeighedRow {
  std::size_t row;
  double weight;
};
void take_square(const ComplexMatrix& p, const std::vector<WeighedRow>& rows, ComplexMatrix& room, ComplexMatrix& out);

/// The columns of X of a line, without D: rows of X_k and A_k are those of δX_k and δY G_k alone, G = Z A. With the squares
/// S_k = Pᴴ W² P of column k of A, its rows E of X that are not zero and their own weights,
///   M_k = S_k(E, E) + W_X² = L Lᴴ,   T_k = S_k − S_k(:, E) M_k⁻¹ S_k(E, :),
/// T_k is what is left of them on δY G_k, and δX_k = M_k⁻¹(right-hand side + S_k(E, :) δY G_k).
class EliminatedColumns {
 public:
  struct Column {
    Eigen::Index first = 0, count = 0;  ///< in X
    ComplexMatrix square;               ///< S_k, N×N
    ComplexMatrix pulled;               ///< S_k(:, E)
    ComplexMatrix lower;                ///< L
    ComplexMatrix answer;               ///< M_k⁻¹ S_k(E, :): δX_k per δY G_k
    ComplexMatrix left;                 ///< T_k
  };

  explicit EliminatedColumns(const LineLayout& layout);

  /// S_k of all columns.
  void take(const LineData& data, const ComplexMatrix& p);

  /// The rest, with the squared weights of X. False where one is not positive definite.
  bool factor(const Eigen::VectorXd& weights);

  const std::vector<Column>& columns() const { return columns_; }

  /// The rows of column k that are not zero, from a matrix with N rows.
  ComplexMatrix rows_of(std::size_t k, const Eigen::Ref<const ComplexMatrix>& from) const;

 private:
  const LineLayout& layout_;
  std::vector<Column> columns_;
  std::vector<std::vector<std::size_t>> measured_;  ///< elements of A by columns
  ComplexMatrix room_;
};

}  // namespace jointid::ident
