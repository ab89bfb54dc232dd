#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jointid::frf {

/// Simulation of the measurement errors of FRFs. H is the exact value, Ĥ the noisy one.
enum class NoiseKind : std::uint8_t {
  uniform,  ///< real and imaginary part each times an independent factor, uniform in [1−p, 1+p] (docs/formulas.md
            ///< §11a)
  gaussian,  ///< as uniform, the factors normal with the same mean 1 and variance p²/3
  circular,  ///< Ĥ = H + e, e complex normal, E|e|² = (p|H|)², independent real and imaginary part
  hammer     ///< Ĥ = H + e by the H1 estimate of a hammer test, see NoiseModel::coherence
};

std::string name(NoiseKind kind);

/// Parses "uniform", "gaussian", "circular" or "hammer"; throws InputError (usage) with the nearest valid
/// word.
NoiseKind parse_noise_kind(std::string_view text);

/// Tukey's contaminated normal, line by line: a `share` of the lines of a set are outlier lines with `factor` times the errors.
struct GrossErrors {
  double share = 0.0;  ///< 0 ≤ share ≤ 1
  double factor = 10.0;
};

/// A noise model. In uniform, gaussian and circular noise a reciprocal pair (r,c) and (c,r) of the set
/// shares its random numbers. So a symmetric set stays symmetric. In a hammer test each FRF is measured
/// separately.
struct NoiseModel {
  NoiseKind kind = NoiseKind::uniform;
  double level = 0.05;  ///< p, 0 ≤ p < 1; not used by hammer

  /// Hammer: coherence γ² of every entry, 0 < γ² ≤ 1; a set with `coherence` has its own per entry. e is complex normal with
  /// E|e|² = |H|²(1−γ²)/(γ²(n_d−1)) (docs/formulas.md §11a). The result has the coherence that such a test of n_d hits would
  /// estimate, γ̂² = |Ĥ|²/(|Ĥ|² + E|e|²·g), g ~ Gamma(n_d−1, 1). In the same formula it gives the variance of e without
  /// bias.
  double coherence = 0.998;
  int averages = 5;  ///< n_d ≥ 2, hits per FRF; only used by hammer

  /// uniform, gaussian, circular: fill `variance` by the model at the noisy value, as a user who knows the model but not H.
  /// Hammer records coherence instead.
  bool record_variance = false;

  bool reciprocal = true;  ///< false: (r,c) and (c,r) have separate random numbers
  /// Constant floor: adds a complex normal error. Its standard deviation is `floor` times the rms of that FRF over the lines of
  /// the set, in the stored quantity (in an accelerance a floor of the accelerometer).
  double floor = 0.0;
  GrossErrors gross{};
  double sign_errors = 0.0;     ///< probability of a flipped direction of a DOF, in both roles
  double position_errors = 0.0; ///< m, standard deviation of a DOF's position, along the line to the nearest node with that DOF
};

/// Throws InputError (usage) with the field that is outside its range.
void validate(const NoiseModel& model);

}  // namespace jointid::frf
