#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace jointid::frf {

/// How the measurement errors of FRFs are simulated. H is the exact value, Ĥ the polluted one.
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

/// Tukey's contaminated normal, line by line: on a `share` of the lines of a set the errors are `factor` times as large.
struct GrossErrors {
  double share = 0.0;  ///< 0 ≤ share ≤ 1
  double factor = 10.0;
};

/// A noise model. In uniform, gaussian and circular noise an FRF and its reciprocal (r,c) and (c,r), when the
/// set has both, share their random numbers, so that a symmetric set stays symmetric. In a hammer test each
/// FRF is measured on its own.
struct NoiseModel {
  NoiseKind kind = NoiseKind::uniform;
  double level = 0.05;  ///< p, 0 ≤ p < 1; not used by hammer

  /// Hammer: coherence γ² of every entry, 0 < γ² ≤ 1; a set that carries `coherence` has its own per entry.
  /// e is complex normal with E|e|² = |H|²(1−γ²)/(γ²(n_d−1)) (docs/formulas.md §11a). The result carries the coherence
  /// that such a test of n_d hits would have estimated, γ̂² = |Ĥ|²/(|Ĥ|² + E|e|²·g), g ~ Gamma(n_d−1, 1): put
  /// into the same formula it gives the variance of e without bias.
  double coherence = 0.998;
  int averages = 5;  ///< n_d ≥ 2, hits per FRF; only used by hammer

  /// uniform, gaussian, circular: fill `variance` by the model's law at the polluted value, as a user would
  /// who knows the law but not H. Hammer records coherence instead.
  bool record_variance = false;

  bool reciprocal = true;  ///< false: (r,c) and (c,r) draw numbers of their own
  /// Constant floor: a complex normal error is added whose standard deviation is `floor` times the rms of that FRF over the
  /// lines of the set, in the quantity the set is stored in (a floor of the accelerometer in an accelerance).
  double floor = 0.0;
  GrossErrors gross{};
  double sign_errors = 0.0;     ///< probability that a DOF's direction is noted the wrong way round, in both roles
  double position_errors = 0.0; ///< m, standard deviation of a DOF's place, along the line to the nearest node with that DOF
};

/// Throws InputError (usage) naming the field that is outside its range.
void validate(const NoiseModel& model);

}  // namespace jointid::frf
