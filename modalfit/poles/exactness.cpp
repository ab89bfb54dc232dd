#include "modalfit/poles/exactness.hpp"

#include <cmath>

#include "modalfit/poles/residues.hpp"

namespace jointid::modalfit {
namespace {

/// Σ|H|²/σ² of an FRF.
double weighted_square(const Band& band, std::size_t entry) {
  const double* parts = reinterpret_cast<const double*>(band.value(entry));
  double sum = 0.0;
  for (std::size_t i = 0; i < 2 * band.lines(); ++i) sum += std::pow(parts[i] * band.weights(entry)[i], 2.0);
  return sum;
}

/// Root of the mean of square(k)/weighted square over the FRFs that were measured.
template <class Square>
double over_modulus(const Band& band, const std::vector<std::size_t>& entries, Square square) {
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const double size = weighted_square(band, entries[k]);
    if (!(size > 0.0)) continue;
    sum += square(k) / size;
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

}  // namespace

double deviation(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles) {
  const Residues residues = fit_residues(band, entries, kind, poles);
  return over_modulus(band, entries, [&](std::size_t k) { return residues.cost[k]; });
}

double relative_noise(const Band& band, const std::vector<std::size_t>& entries) {
  return over_modulus(band, entries, [&](std::size_t k) {
    double rows = 0.0;
    for (std::size_t i = 0; i < 2 * band.lines(); ++i) rows += band.weights(entries[k])[i] > 0.0 ? 1.0 : 0.0;
    return rows;
  });
}

bool is_exact(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles) {
  return deviation(band, entries, kind, poles) <= nearly_exact;
}

}  // namespace jointid::modalfit
