#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/complex.hpp"
#include "base/statistics.hpp"

namespace jointid::records {

/// A value that is not known.
inline constexpr Complex unknown{nan, nan};

/// How an FRF is made of the averaged spectra S_ff = Σ|F|², S_xf = Σ X F*, S_xx = Σ|X|² of n blows (or segments).
enum class Estimator : std::uint8_t {
  h1,  ///< S_xf / S_ff: unbiased where the force is free of noise
  h2,  ///< S_xx / S_fx: unbiased where the motion is free of noise
  hv  ///< √(S_xx / S_ff) S_xf / |S_xf|: the geometric mean of both; total least squares with noise in proportion to the signals
      ///< (Rocklin, Crowley & Vold, IMAC 1985), so that it does not depend on units
};

/// "h1", "h2" or "hv", in any case. Throws InputError (usage) with the nearest word.
Estimator parse_estimator(std::string_view text);
std::string name(Estimator estimator);

/// Where variances and covariances come from.
enum class NoiseFrom : std::uint8_t {
  residuals,  ///< what H1 leaves of the motions, E = X − H1 F, the same on all blows; its diagonal is that of the coherences
  scatter     ///< every blow weighs by its own residual; real and imaginary part apart
};

/// "residuals" or "scatter". Throws InputError (usage).
NoiseFrom parse_noise_from(std::string_view text);

/// Spectra of n blows or segments with one force and R motions, on F lines.
struct Spectra {
  std::size_t lines = 0, responses = 0, count = 0;
  std::vector<Complex> force;   ///< [n, F]
  std::vector<Complex> motion;  ///< [n, R, F]

  Complex force_at(std::size_t h, std::size_t line) const { return force[h * lines + line]; }
  Complex motion_at(std::size_t h, std::size_t r, std::size_t line) const { return motion[(h * responses + r) * lines + line]; }
};

/// FRFs of one reference and how exact they are, in the units of the spectra. NaN where the force is zero on a line, and for
/// coherences, variances and covariances of a single blow.
struct Estimate {
  std::vector<Complex> frf;         ///< [F, R]
  std::vector<double> coherence;    ///< [F, R] |S_xf|² / (S_ff S_xx)
  std::vector<Complex> variance;    ///< [F, R] of real and imaginary part
  std::vector<Complex> covariance;  ///< [F, P] E[e_r e_s*], s ≤ r (frf::pair_index); empty where there is a factor
  std::vector<Complex> factor{};    ///< [F, R, K] L, E[e e^H] = L Lᴴ, where asked for
};

/// How an Estimate is asked to tell its covariances.
enum class CovarianceForm : std::uint8_t { pairs, factor };

/// The columns K of the factor that the covariances of n blows have: n less one where a combination of all blows is left with nothing,
/// of residuals and of the scatter about H1.
std::size_t factor_rank(std::size_t count, Estimator estimator, NoiseFrom noise);

/// FRFs with the covariances of their errors, which all motions of a blow share: noise of the hammer's signal, blows that hit
/// another point, a disturbance of the structure.
///
/// Residuals: C_rs = Σ_h E_rh E_sh* / (S_ff (n_e − 1)), n_e the `effective` number of averages (n where segments do not overlap);
/// unbiased for errors of equal strength on all blows. C_rr is |H1|²(1−γ²)/(γ²(n_e−1)), see frf::h1_variance; half of it each are
/// the variances of real and imaginary part. For H2 and Hv times (H/H1)_r (H/H1)_s*, to first order in 1 − γ².
///
/// Scatter: C_rs = Σ_h u_rh u_sh* (n−1)/(n_e−1), u the influence of a blow on the estimate: F* E/S_ff of H1, X*(X − H2 F)/S_fx of
/// H2, Hv (u₁/H1 + u₂/H2)/2 of Hv, each divided by √(1 − w), w the blow's share of S_ff or S_xx (MacKinnon & White 1985, HC2),
/// which makes it unbiased where the errors are of equal strength, and right to first order where they are not.
///
/// The rank of C is at most n − 1: with fewer blows than responses the matrix is singular, and whoever inverts it must add to its
/// diagonal.
Estimate estimate(const Spectra& spectra, Estimator estimator, NoiseFrom noise, double effective,
                  CovarianceForm form = CovarianceForm::pairs);

}  // namespace jointid::records
