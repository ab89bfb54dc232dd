#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "ident/likelihood/data/slope_kernel.hpp"
#include "ident/likelihood/data/symmetric_frfs.hpp"

namespace jointid::ident {

/// Derivatives of the FRFs of a structure on a line by the frequency. Its FRFs have poles in common: through 2d + 1 neighbouring lines,
/// nine or fewer of them, each is a polynomial of degree d over one denominator of degree d for all, which least squares weighed by the
/// errors find. Lines may be farther apart than resonances are wide. With the denominator q, 1 on the own line, H' = (q H)' − q' H.
class FrfSlopes {
 public:
  static constexpr std::size_t most_lines = FrfLanes::most_lines;  ///< four poles: close resonances are told apart

  /// `frequency` of the lines, an odd number of them, and their FRFs, of which those between `coordinates` are the structure's; `own`:
  /// where the derivatives are.
  FrfSlopes(const std::vector<std::size_t>& coordinates, const std::vector<double>& frequency,
            std::vector<const MeasuredFrfs*> lines, std::size_t own);

  /// By the unit of `frequency`; NaN where the FRF is not known on all lines, or zero by symmetry on one.
  Complex of(Element element) const;
  /// What every derivative has of the value of its FRF on the line itself, a factor: nearly all of it on a resonance.
  Complex of_own_value() const { return factor_[own_]; }

 private:
  static constexpr int most = static_cast<int>(most_lines);
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;
  using Values = Eigen::Matrix<Complex, Eigen::Dynamic, 1, Eigen::ColMajor, most, 1>;

  /// Numbers on the lines, only the first of them used.
  using OnLines = std::array<Complex, most_lines>;

  class Blocks;  ///< of FRFs that have an error on a line

  /// The FRF on the lines; false: not known on all of them, or zero by symmetry.
  using Neighbours = std::array<const Measured*, most_lines>;
  bool take(Element element, Neighbours& out) const;
  Values denominator(const Blocks& blocks, const PolynomialRemainder& off, const Values& before, Complex& rate) const;

  std::vector<const MeasuredFrfs*> lines_;
  Numbers place_;     ///< of the lines, 0: own
  OnLines factor_{};  ///< of the FRF on a line in the derivative
  std::size_t own_;
};

}  // namespace jointid::ident
