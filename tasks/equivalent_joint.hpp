#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace jointid::tasks {

/// FRFs at the two ends 1 and 2 of a massless joint between them, by line (docs/formulas.md §12), m/N.
struct JointLines {
  std::vector<std::complex<double>> a, b, c;  ///< without the joint: h_11, h_22, h_12
  std::vector<std::complex<double>> h1, h3;   ///< with it: h_11, h_21
  std::vector<std::complex<double>> gap;      ///< h_a + h_b − 2h_c, or its substitute
  /// Residuals relative to |h1| and |h3|, for errors in proportion to the FRFs. False: absolute ones; then the lines next to the
  /// resonance dominate, where the gap is least accurate.
  bool relative = false;
};

/// The gap of (7.11), from the FRFs without the joint.
std::vector<std::complex<double>> difference_gap(const JointLines& lines);

/// The gap of (7.18): 2(h_a h_b − h_c²)/(h_1r + h_3r) (7.14), from the FRFs with the joint clamped rigid. It is no difference of
/// nearly equal numbers; its error is the elasticity of the clamped joint.
std::vector<std::complex<double>> rigid_gap(const JointLines& lines, const std::vector<std::complex<double>>& h1_rigid,
                                            const std::vector<std::complex<double>>& h3_rigid);

/// Sign(Re h)·|h| (7.19): for structures with so little damping that the phase of their FRFs is only error.
std::complex<double> real_frf(std::complex<double> h);

struct EquivalentJoint {
  double stiffness = 0.0;  ///< k_j, N/m
  double damping = 0.0;    ///< d_j, N/m
  /// Standard deviation of either, N/m, from the scatter of the residuals. An error of a whole FRF (a gain) is not in
  /// it.
  double deviation = 0.0;
  double misfit = 0.0;     ///< √(Σ|r|²/Σ|h|²) over h1 and h3; rms of |r|/|h| of relative ones
  bool settled = true;     ///< false: no minimum was found
};

/// Minimises Σ|h1 − (D + h_a h)/(gap + h)|² + |h3 − (D + h_c h)/(gap + h)|² over h = 1/(k_j + i d_j), D = h_a h_b − h_c² (7.11),
/// (7.18). Damped Gauss–Newton steps start from the best of the values from h1 or h3 of single lines. All vectors are as long as
/// `a`, one line at least.
EquivalentJoint equivalent_joint(const JointLines& lines);

}  // namespace jointid::tasks
