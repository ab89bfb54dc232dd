#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/complex.hpp"

namespace jointid::frf {

/// Size of covariances Σ = L Lᴴ + diag(d): the columns of L, and whether there is a d.
struct FactorShape {
  std::size_t rank = 0;  ///< 0: there is no factor
  bool diagonal = false;

  /// Whether it is smaller than the pairs of so many responses.
  bool is_smaller(std::size_t responses) const { return rank > 0 && 2 * rank + (diagonal ? 1 : 0) < responses + 1; }
};

/// Covariances of the errors of each line and reference over the responses, Σ = L Lᴴ + diag(d): a few causes that the responses share,
/// and what each has of its own. A row of L is NaN (and d, too) where the error of an FRF is not known.
struct CovarianceFactor {
  std::size_t rank = 0;          ///< columns K of L; 0: there is none
  std::vector<Complex> rows;     ///< [F,R,K,C] L, of the receptance
  std::vector<double> diagonal;  ///< [F,R,C] d ≥ 0, or empty: zero

  bool any() const { return rank > 0; }
  FactorShape shape() const { return {rank, !diagonal.empty()}; }
};

/// Covariances of some lines in one of their two forms, or none, and what references have in common.
struct CovarianceLines {
  std::span<const Complex> pairs{};     ///< [line, P, C] FrfSet::covariance
  std::span<const Complex> rows{};      ///< [line, R, K, C]
  std::span<const double> diagonal{};   ///< [line, R, C]
  std::span<const Complex> reference_correlation{};  ///< [line, C, C], beside either form
};

}  // namespace jointid::frf
