#pragma once

#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// Whether one of `tried` numbers is by chance as many standard deviations from what it should be, in more than one of a thousand checks:
/// tried · P(|t_ν| > deviations) ≥ 10⁻³, t_ν of Student's law (Bonferroni's bound). `freedom`: ν, the degrees of freedom of the scatter
/// that told the standard deviation; of fewer than one nothing is beyond chance.
bool may_be_chance(double deviations, double freedom, double tried);

/// Degrees of freedom of a standard deviation from the median of so many absolute values, for it has 0.37 of the efficiency of the root of
/// their mean square (Rousseeuw & Croux 1993).
inline double freedom_of_median(double count) { return 0.37 * (count - 1.0); }

/// Relative error of a file's FRFs by its covariances: geometric mean over lines of the rms. Only with errors.
double relative_error(const CheckedFile& file);

/// H_ij against H_ji over the coordinates that a file has in both roles.
struct ReciprocityTest {
  Dofs dofs;
  double level =
      0.0;  ///< geometric mean over pairs and lines of |H_ij − H_ji|/√(|H_ij|² + |H_ji|²); 0 with fewer than two coordinates
  std::vector<double> row;  ///< mean square of that in the pairs of a coordinate
  std::vector<double> gain,
      deviation;  ///< factor that the responses of a coordinate lack (or that its references have), and its error
  std::vector<double> freedom;  ///< degrees of freedom of that error
  /// A mass m that travels with a sensor of translations: H_ij − H_ji = −ω²m(H_ij H_jj − H_ji H_ii), by least squares.
  double mass = 0.0, mass_deviation = 0.0, mass_freedom = 0.0;
};

ReciprocityTest reciprocity_test(const CheckedFile& file, bool with_rows);

/// The sign of the imaginary parts of driving points: Im H_kk ≤ 0 where a structure takes energy (e^{+iωt}).
struct PassivityTest {
  Dofs dofs;
  std::vector<double> excess;  ///< Σ Im H_kk over what noise would give it: the file's, or of relative size `noise`
  double total = 0.0;          ///< the same of all together
};

PassivityTest passivity_test(const CheckedFile& file, double noise);

/// Phases modulo 180°, which are near 0 for receptances of lightly damped structures.
struct PhaseTest {
  double real_share = 1.0;  ///< mean over lines of Re(mean of (H/|H|)²): 1 real, −1 imaginary
  double delay = 0.0;       ///< s that the responses lag, from the phases' slope
  double delay_deviation = 0.0;
  double coherence = 0.0;  ///< mean over lines of |mean of (H/|H|)²|
};

PhaseTest phase_test(const CheckedFile& file, bool with_delay);

}  // namespace jointid::ident
