#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "minimise/linear/line_product.hpp"

namespace jointid::ident {

/// A complex matrix as two real ones, row-major [rows × columns].
struct SplitMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<double> re, im;

  void resize(std::size_t r, std::size_t c);
};

/// R_A Z_j R_Bᵀ = C'': the P·Q equations that stand for the M·L of a weighted product over N_A × N_B elements of Z_j,
/// P = min(M,N_A), Q = min(L,N_B).
struct Compressed {
  SplitMatrix ra;  ///< [P×N_A]
  SplitMatrix rb;  ///< [Q×N_B]
  SplitMatrix c;   ///< [P×Q]
};

/// Whether every element of C₁ and C₂ of a line is finite.
bool right_side_is_finite(const minimise::LineProduct& line);

/// Some rows and columns of a LineProduct, all of whose equations are in use, with their weights. Only the elements of Z_j
/// in `a_dofs` × `b_dofs` have coefficients in them.
struct SubProduct {
  std::span<const std::size_t> a_dofs;     ///< columns of A
  std::span<const std::size_t> b_dofs;     ///< rows of B
  std::span<const std::size_t> rows;       ///< of A and C
  std::span<const std::size_t> columns;    ///< of B and C
  std::span<const double> row_weight;      ///< one per entry of `rows`
  std::span<const double> column_weight;   ///< one per entry of `columns`
};

/// Replaces W_r A Z_j B W_c = W_r (C₁ − C₂) W_c by its compressed form (docs/formulas.md §5): with the thin QR factors
/// W_r A = Q_A R_A and (B W_c)ᵀ = Q_B R_B, C'' = Q_Aᴴ W_r (C₁ − C₂) W_c Q_B*. The least-squares problem is unchanged, and
/// nothing is squared. Costs about 8(MN(N+L) + LN²) flops instead of the 8·M·L·N² of writing the equations out.
class KroneckerCompressor {
 public:
  /// With `same_a`, rows, row weights and a_dofs are those of the previous call on the same line, and A's factor is kept.
  void compress(const minimise::LineProduct& line, const SubProduct& part, bool same_a, Compressed& out);

  /// The same equations without compression (P = M, Q = L): cheaper when there are few of them.
  static void copy(const minimise::LineProduct& line, const SubProduct& part, Compressed& out);

 private:
  /// A weighted matrix and the Q of its thin QR, columns contiguous.
  struct Factor {
    std::vector<double> re, im, q_re, q_im;
  };

  template <class Element>
  void factor(const Element& element, std::span<const double> weight, std::size_t n, Factor& factor, SplitMatrix& r);

  std::vector<double> tau_;
  Factor a_, b_;
  std::vector<double> panel_re_, panel_im_;  ///< a few columns of C
  std::vector<double> d_re_, d_im_;          ///< Q_Aᴴ W_r C
};

}  // namespace jointid::ident
