#include "modalfit/poles/doubled.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/complex.hpp"
#include "modalfit/band/normal_block.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/residues.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;

constexpr double least_unexplained = 0.25;  ///< of what the second pole saves

double s_plane_distance(const ModelKind& kind, const Pole& a, const Pole& b) {
  return std::hypot(a.frequency_hz - b.frequency_hz, half_width_hz(kind, a) - half_width_hz(kind, b));
}

constexpr double much_worse = 100.0;       ///< in mean square

bool is_same(const Pole& a, const Pole& b) { return std::abs(a.frequency_hz - b.frequency_hz) < 1e-9 * a.frequency_hz; }

/// The cost of one FRF with a pole of its own in place of pole `at`, and the step of (ln f, damping) that would lower it to first order.
struct OwnPole {
  double cost = std::numeric_limits<double>::infinity(), to_frequency_hz = 0.0, to_damping = 0.0;
};

OwnPole own_pole(const Band& band, std::size_t entry, const ModelKind& kind, const std::vector<Pole>& poles, std::size_t at) {
  const RealBasis basis(make_basis(kind, poles, band.frequency_hz, band.scale_hz(), true));
  const NormalBlock block(basis, band, entry);
  OwnPole out{.cost = block.cost()};
  const auto terms = block.pole_terms(basis);
  const auto i = static_cast<Index>(2 * at);
  const double a = terms.curvature(i, i), b = terms.curvature(i, i + 1), c = terms.curvature(i + 1, i + 1);
  const double f = terms.gradient(i), g = terms.gradient(i + 1), determinant = a * c - b * b;
  if (!(determinant > 1e-9 * a * c)) return out;
  out.to_frequency_hz = poles[at].frequency_hz * (c * f - b * g) / determinant;
  out.to_damping = (a * g - b * f) / determinant;
  return out;
}

/// The least cost of one FRF by steps from a pole of its own that stays within the half width of the common one, its damping within
/// itself.
double own_cost(const Band& band, std::size_t entry, const ModelKind& kind, std::vector<Pole> poles, std::size_t at, const Pole& start) {
  constexpr int most_steps = 3;
  const Pole common = poles[at];
  const double half_width = half_width_hz(kind, common);
  const auto kept_near = [&](const Pole& pole) {
    return Pole{std::clamp(pole.frequency_hz, common.frequency_hz - half_width, common.frequency_hz + half_width),
                std::clamp(pole.damping, 0.1 * common.damping, 2.0 * common.damping)};
  };
  poles[at] = kept_near(start);
  OwnPole best = own_pole(band, entry, kind, poles, at);
  double share = 1.0;
  for (int step = 0; step < most_steps; ++step) {
    const Pole before = poles[at];
    poles[at] = kept_near({before.frequency_hz + share * best.to_frequency_hz, before.damping + share * best.to_damping});
    const OwnPole next = own_pole(band, entry, kind, poles, at);
    if (next.cost < best.cost) {
      best = next;
      continue;
    }
    poles[at] = before;
    share *= 0.3;
  }
  return best.cost;
}

/// Complex frequency f + i·(half width).
Complex complex_frequency(const ModelKind& kind, const Pole& pole) { return {pole.frequency_hz, half_width_hz(kind, pole)}; }

/// Where the two poles act as one in one FRF: their centroid, weighted by its residues; the common pole where that is none.
Pole centroid(const ModelKind& kind, const std::array<Pole, 2>& two, const std::array<Complex, 2>& residue, const Pole& common) {
  const Complex at = (residue[0] * complex_frequency(kind, two[0]) + residue[1] * complex_frequency(kind, two[1])) /
                     (residue[0] + residue[1]);
  if (!(std::isfinite(std::norm(at)) && at.real() > 0.0 && at.imag() > 0.0)) return common;
  return {at.real(), at.imag() * damping_per_zeta(kind) / at.real()};
}

/// The cost of all FRFs, each with one pole of its own in place of the two.
double cost_of_own_poles(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& one,
                         const RefinedPoles& two, const std::array<std::size_t, 2>& pair) {
  const Residues residues = fit_residues(band, entries, kind, two.poles);
  const std::size_t own = kind.real_modes ? 1 : 2;
  const Pole common = one.poles[pair[0]];
  std::vector<double> cost(entries.size());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    std::array<Complex, 2> residue;
    for (std::size_t m = 0; m < 2; ++m) {
      const std::size_t at = k * residues.columns + pair[m] * own;
      residue[m] = {residues.coefficients[at], own == 2 ? residues.coefficients[at + 1] : 0.0};
    }
    const Pole start = centroid(kind, {two.poles[pair[0]], two.poles[pair[1]]}, residue, common);
    cost[k] = std::min(own_cost(band, entries[k], kind, one.poles, pair[0], common),
                       own_cost(band, entries[k], kind, one.poles, pair[0], start));
  });
  return std::accumulate(cost.begin(), cost.end(), 0.0);
}

/// Whether the two poles follow the FRFs to digits that no measurement has, and one pole does not, not even one of each FRF's own.
bool two_are_exact(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const RefinedPoles& one,
                   const RefinedPoles& two, const std::array<std::size_t, 2>& pair) {
  if (!is_exact(band, entries, kind, two.poles)) return false;
  const double unexplained = entries.size() > 1 ? cost_of_own_poles(band, entries, kind, one, two, pair) : one.cost;
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
  if (entries.size() == 1) return true;
  const double saving = one.cost - two.cost, unexplained = cost_of_own_poles(band, entries, kind, one, two, pair) - two.cost;
  const double misfit = two.freedom > 0.0 ? std::max(1.0, two.cost / two.freedom) : 1.0;
  const double noise = misfit * chi_square_quantile(2.0 * static_cast<double>(entries.size()) + 2.0, significance_deviations);
  return unexplained < std::max(least_unexplained * saving, noise);
}

}  // namespace jointid::modalfit
