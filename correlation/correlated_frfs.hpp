#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::correlation {

/// One FRF in two sets, over the lines that both have.
struct FrfAgreement {
  frf::Dof response, reference;  ///< as in the first set
  std::size_t lines = 0;         ///< where both are measured
  double frac = 0.0;             ///< frac()
  double lac = 0.0;              ///< mean of lac() over the lines
  double coherence = 0.0;        ///< mean of coherence_criterion()
  double error_db = 0.0;         ///< 20 log₁₀|b/a|, rms over the lines where neither is zero
  double chi_square = 0.0;  ///< Σ (Re δ)²/σ²_re + (Im δ)²/σ²_im, σ² the sum of both; NaN where neither set states its noise
  double freedom = 0.0;  ///< numbers in it

  /// χ² over degrees of freedom; NaN if not known.
  double ratio() const { return chi_square / freedom; }
};

/// One line of two sets, means over the references that both have.
struct LineAgreement {
  double frequency_hz = 0.0;
  double shape = 0.0;      ///< diagonal of fdac()
  double amplitude = 0.0;  ///< amplitude_criterion()
};

/// How two sets of FRFs of one structure agree.
struct CorrelatedFrfs {
  std::vector<FrfAgreement> frfs;
  std::vector<LineAgreement> lines;
  double chi_square = 0.0, freedom = 0.0;  ///< of all FRFs

  double ratio() const { return chi_square / freedom; }
};

/// Compares FRFs of the same coordinates, whatever their signs, on lines that agree to a millionth. Throws InputError (data)
/// where the sets have no FRF or no line in common.
CorrelatedFrfs correlate(const frf::FrfSet& one, const frf::FrfSet& other);

/// fdac() of the FRFs to one reference over the responses that both have, and its lines.
struct ShapesOverLines {
  std::vector<double> frequency_hz;  ///< [line], rows and columns of `fdac`
  Eigen::MatrixXd fdac;
};

/// As correlate(), and where a set does not have the reference.
ShapesOverLines shapes_over_lines(const frf::FrfSet& one, const frf::FrfSet& other, const frf::Dof& reference);

}  // namespace jointid::correlation
