#include "modalfit/poles/doubled.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/complex.hpp"
#include "modalfit/band/normal_block.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/residues.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;

constexpr double least_unexplained = 0.5;
constexpr double telling_deviations = 4.0;  ///< standard deviations of residues that a FRF must have to tell

double s_plane_distance(const ModelKind& kind, const Pole& a, const Pole& b) {
  return std::hypot(a.frequency_hz - b.frequency_hz, half_width_hz(kind, a) - half_width_hz(kind, b));
}

constexpr double much_worse = 100.0;       ///< in mean square

bool is_same(const Pole& a, const Pole& b) { return std::abs(a.frequency_hz - b.frequency_hz) < 1e-9 * a.frequency_hz; }

/// What poles of each FRF's own in place of pole `at` would take off the cost, to first order: Σ gᵀC⁻¹g. An FRF that would have to move it
/// by more than the half width, or its damping by more than itself, is not explained so.
double own_saving(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles,
                  std::size_t at) {
  const RealBasis basis(make_basis(kind, poles, band.frequency_hz, band.scale_hz(), true));
  std::vector<double> saving(entries.size());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    const auto terms = NormalBlock(basis, band, entries[k]).pole_terms(basis);
    const auto i = static_cast<Index>(2 * at);
    const double a = terms.curvature(i, i), b = terms.curvature(i, i + 1), c = terms.curvature(i + 1, i + 1);
    const double f = terms.gradient(i), g = terms.gradient(i + 1), determinant = a * c - b * b;
    if (!(determinant > 1e-9 * a * c)) return;
    const double frequency_hz = poles[at].frequency_hz * (c * f - b * g) / determinant, damping = (a * g - b * f) / determinant;
    const bool is_near = std::abs(frequency_hz) < half_width_hz(kind, poles[at]) && std::abs(damping) < poles[at].damping;
    if (is_near) saving[k] = (c * f * f - 2.0 * b * f * g + a * g * g) / determinant;
  });
  return std::accumulate(saving.begin(), saving.end(), 0.0);
}

/// Complex frequency f + i·(half width).
Complex complex_frequency(const ModelKind& kind, const Pole& pole) { return {pole.frequency_hz, half_width_hz(kind, pole)}; }

/// Whether the centroid of the two poles, weighted by their residues, stays between them in all FRFs.
bool acts_as_one(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles,
                 const std::array<std::size_t, 2>& pair) {
  const Residues residues = fit_residues(band, entries, kind, poles);
  const std::size_t own = kind.real_modes ? 1 : 2;
  const Complex difference = complex_frequency(kind, poles[pair[0]]) - complex_frequency(kind, poles[pair[1]]);
  const double half_width = std::sqrt(half_width_hz(kind, poles[pair[0]]) * half_width_hz(kind, poles[pair[1]]));
  for (std::size_t k = 0; k < entries.size(); ++k) {
    std::array<Complex, 2> residue;
    double variance = 0.0;
    for (std::size_t m = 0; m < 2; ++m) {
      const std::size_t at = k * residues.columns + pair[m] * own;
      residue[m] = {residues.coefficients[at], own == 2 ? residues.coefficients[at + 1] : 0.0};
      variance += residues.variance[at] + (own == 2 ? residues.variance[at + 1] : 0.0);
    }
    const Complex sum = residue[0] + residue[1];
    if (std::norm(residue[0]) + std::norm(residue[1]) < telling_deviations * telling_deviations * variance) continue;
    if (std::abs(0.5 * difference * (residue[0] - residue[1])) > half_width * std::abs(sum)) return false;
  }
  return true;
}

/// Whether the two poles follow the FRFs to digits that no measurement has, and one pole does not, not even one of each FRF's own.
bool two_are_exact(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& one,
                   const RefinedPoles& two, const std::array<std::size_t, 2>& pair) {
  if (!is_exact(band, entries, kind, two.poles)) return false;
  const double unexplained = one.cost - (entries.size() > 1 ? own_saving(band, entries, kind, one.poles, pair[0]) : 0.0);
  return unexplained > std::max(much_worse * two.cost, 2.0 * two.freedom);
}

}  // namespace

double half_width_hz(const ModelKind& kind, const Pole& pole) {
  return pole.damping * pole.frequency_hz / damping_per_zeta(kind);
}

std::optional<std::array<std::size_t, 2>> doubled_pair(const std::vector<Pole>& poles, const ModelKind& kind,
                                                       const std::vector<std::array<Pole, 2>>& kept) {
  std::optional<std::array<std::size_t, 2>> found;
  double least = 1.0;
  for (std::size_t r = 0; r < poles.size(); ++r) {
    for (std::size_t s = r + 1; s < poles.size(); ++s) {
      const double bandwidth = 2.0 * std::sqrt(half_width_hz(kind, poles[r]) * half_width_hz(kind, poles[s]));
      const double distance = s_plane_distance(kind, poles[r], poles[s]);
      const auto is_this = [&](const std::array<Pole, 2>& pair) { return is_same(pair[0], poles[r]) && is_same(pair[1], poles[s]); };
      const bool known = std::ranges::any_of(kept, is_this);
      if (known || !(distance < least * bandwidth)) continue;
      least = distance / bandwidth;
      found = {r, s};
    }
  }
  return found;
}

std::vector<Pole> with_one(std::vector<Pole> poles, const std::array<std::size_t, 2>& pair) {
  Pole& first = poles[pair[0]];
  const Pole& second = poles[pair[1]];
  first = {0.5 * (first.frequency_hz + second.frequency_hz), std::sqrt(first.damping * second.damping)};
  poles.erase(poles.begin() + static_cast<std::ptrdiff_t>(pair[1]));
  return poles;
}

bool one_pole_does(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& one,
                   const RefinedPoles& two, const std::array<std::size_t, 2>& pair) {
  if (two_are_exact(band, entries, kind, one, two, pair)) return false;
  if (entries.size() == 1 || acts_as_one(band, entries, kind, two.poles, pair)) return true;
  const double saving = one.cost - two.cost;
  const double unexplained = saving - own_saving(band, entries, kind, one.poles, pair[0]);
  const double misfit = two.freedom > 0.0 ? std::max(1.0, two.cost / two.freedom) : 1.0;
  const double noise = misfit * chi_square_quantile(2.0 * static_cast<double>(entries.size()) + 2.0, significance_deviations);
  return unexplained < std::max(least_unexplained * saving, noise);
}

}  // namespace jointid::modalfit
