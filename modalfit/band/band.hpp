#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::modalfit {

/// The FRFs that are fitted, entry by entry, with the weight of every value. Entry e = response·references + reference.
struct Band {
  std::vector<double> frequency_hz;           ///< [F] > 0
  std::size_t responses = 0, references = 0;
  std::vector<std::complex<double>> values;   ///< [E,F] receptance; 0 where not measured
  std::vector<double> weight;                 ///< [E,F,2] 1/σ of real and imaginary part; 0 where not measured
  bool known_noise = false;                   ///< σ from variances or coherences; else up to a factor per entry, to be estimated
  frf::Quantity quantity = frf::Quantity::receptance;  ///< as stored
  double precision = 0x1p-53;  ///< largest relative rounding error of the numbers as they were stored

  std::function<void()> watch{};  ///< called before an FRF is worked on, by any thread; what it throws ends the work

  void look() const {
    if (watch) watch();
  }
  std::size_t lines() const { return frequency_hz.size(); }
  std::size_t entries() const { return responses * references; }
  const std::complex<double>* value(std::size_t entry) const { return values.data() + entry * lines(); }
  const double* weights(std::size_t entry) const { return weight.data() + entry * lines() * 2; }
  double* weights(std::size_t entry) { return weight.data() + entry * lines() * 2; }
  /// f_scale of Basis: the highest line.
  double scale_hz() const { return frequency_hz.back(); }
};

/// Lines of the set inside `range_hz` (all without it) but 0 Hz. σ² comes from the set's variances, or by H1 from its
/// coherences; a zero variance (an exact value) counts as 1e-6 of the modulus. Without either, σ is taken constant per entry in the
/// stored quantity, a hundredth of its rms, until noise_laws() knows better. Throws InputError when fewer than 8 lines are left, nothing
/// was measured on them, or the largest receptance is outside 1e-280 … 1e280 m/N.
Band make_band(const frf::FrfSet& set, const std::optional<std::array<double, 2>>& range_hz);

/// A power of four near the largest real or imaginary part of the receptances: in it they and their variances are numbers.
double unit_of(const Band& band);
/// Values times a factor, and the weights that belong to them.
void multiply(Band& band, double factor);

}  // namespace jointid::modalfit
