#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ident/equations/kronecker.hpp"
#include "minimise/linear/line_product.hpp"

namespace jointid::ident {

/// How far the equations E z = p of all lines move, as a 2-norm over the weighted rows, when every FRF has a relative error of
/// 1: |δp| ≤ right(), and the column of E for Z_j(p,q) moves by at most 2·coefficient(p,q), once for A and once for B.
/// Cancellation in C₁ − C₂, in differences of columns (springs) and in what a method inverts is seen here, and nowhere in E.
class RoundingScale {
 public:
  /// Adds the equations of one product, all weights times `factor`.
  void add(const minimise::LineProduct& line, const SubProduct& part, double factor);

  /// The same where A has the columns and B the rows of some joint coordinates alone, of `joint` in all: those of `part` are places
  /// among them, `a_dofs` and `b_dofs` what they stand for.
  void add(const minimise::LineProduct& line, const SubProduct& part, double factor, std::span<const std::size_t> a_dofs,
           std::span<const std::size_t> b_dofs, std::size_t joint);
  void merge(const RoundingScale& other);

  /// As numbers, for another process.
  std::vector<double> packed() const;
  void merge_packed(std::span<const double> packed);

  double right() const;
  /// √Σ‖A_p‖²‖B_q‖² over all products; 0 for elements that no equation touches.
  double coefficient(std::size_t p, std::size_t q) const;

 private:
  std::size_t joint_ = 0;            ///< N
  double right2_ = 0.0;              ///< squares
  std::vector<double> coefficient2_; ///< [N×N]
  std::vector<double> a2_, b2_;      ///< of one product
};

}  // namespace jointid::ident
