#include "modalfit/poles/residual_peaks.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "modalfit/band/normal_block.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int own_iterations = 3;
constexpr double narrowest = 0.35, widening = 1.8;  ///< half widths, in lines
constexpr double filter_reach = 8.0;                ///< of the filter, in half widths
constexpr std::size_t least_reach = 6;              ///< lines
constexpr double lines_per_width = 64.0;            ///< of the range for the widest peak
constexpr double two_lines = 25.0;                  ///< |residual|²/σ² on a second line: once in 270,000
constexpr double standing_out = 0.25;               ///< of the moduli of the model's terms, 2 dB
constexpr std::size_t most_peaks = 40;

/// An FRF's residuals over σ and the moduli of the model's terms likewise, line by line.
struct Whitened {
  std::vector<Complex> residual;
  std::vector<double> terms;
  std::vector<Complex> sum, moment;  ///< [lines+1] of residual and line·residual
  std::vector<double> square;        ///< [lines+1] of |residual|²
};

/// The poles of one FRF's own, a step from those given; modes one by one.
std::vector<Pole> own_step(const NormalBlock& block, const RealBasis& basis, const ModelKind& kind, std::vector<Pole> own,
                           const std::vector<Pole>& common) {
  const auto terms = block.pole_terms(basis);
  for (std::size_t r = 0; r < own.size(); ++r) {
    const auto i = static_cast<Index>(2 * r);
    const double a = terms.curvature(i, i), b = terms.curvature(i, i + 1), c = terms.curvature(i + 1, i + 1), d = a * c - b * b;
    if (!(d > 1e-9 * a * c)) continue;
    const double by_frequency = (c * terms.gradient(i) - b * terms.gradient(i + 1)) / d;
    const double by_damping = (a * terms.gradient(i + 1) - b * terms.gradient(i)) / d;
    const double f = common[r].frequency_hz, width = half_width_hz(kind, common[r]);
    own[r].frequency_hz = std::clamp(own[r].frequency_hz * (1.0 + by_frequency), f - width, f + width);
    own[r].damping = std::clamp(own[r].damping + by_damping, 0.5 * common[r].damping, 2.0 * common[r].damping);
  }
  return own;
}

Whitened whitened(const Band& band, std::size_t entry, const ModelKind& kind, const std::vector<Pole>& poles) {
  std::vector<Pole> own = poles;
  double least = 0.0;
  VectorXd residual, terms;
  for (int iteration = 0; iteration <= own_iterations; ++iteration) {
    const RealBasis basis(make_basis(kind, own, band.frequency_hz, band.scale_hz(), true));
    const NormalBlock block(basis, band, entry);
    if (iteration == 0 || block.cost() < least) {
      least = block.cost();
      residual = block.residual();
      terms = basis.columns.cwiseAbs() * block.coefficients().cwiseAbs();
    }
    if (poles.empty() || iteration == own_iterations) break;
    own = own_step(block, basis, kind, std::move(own), poles);
  }
  Whitened out;
  const double* weight = band.weights(entry);
  out.sum.emplace_back();
  out.moment.emplace_back();
  out.square.push_back(0.0);
  for (std::size_t i = 0; i < band.lines(); ++i) {
    const auto row = static_cast<Index>(2 * i);
    out.residual.emplace_back(residual(row), residual(row + 1));
    out.terms.push_back(std::hypot(weight[2 * i] * terms(row), weight[2 * i + 1] * terms(row + 1)));
    out.sum.push_back(out.sum.back() + out.residual[i]);
    out.moment.push_back(out.moment.back() + static_cast<double>(i) * out.residual[i]);
    out.square.push_back(out.square.back() + std::norm(out.residual[i]));
  }
  return out;
}

/// The filter of one half width at an offset from the middle line; of unit norm, without mean and slope.
struct PeakFilter {
  double half_width, offset;
  std::size_t reach_lines;
  std::vector<Complex> taps;  ///< conjugated
  double norm = 1.0;          ///< of 1/(1 + i(f−f₀)/h) without mean and slope

  PeakFilter(double h, double at)
      : half_width(h), offset(at), reach_lines(std::max(least_reach, static_cast<std::size_t>(std::ceil(filter_reach * h)))) {
    const double n = static_cast<double>(size()), middle = static_cast<double>(reach_lines);
    Complex mean = 0.0, slope = 0.0;
    double squares = 0.0;
    for (std::size_t j = 0; j < size(); ++j) {
      const double t = static_cast<double>(j) - middle;
      taps.push_back(1.0 / Complex(1.0, (t - offset) / h));
      mean += taps[j] / n;
      slope += t * taps[j];
      squares += t * t;
    }
    double sum = 0.0;
    for (std::size_t j = 0; j < size(); ++j) {
      taps[j] = std::conj(taps[j] - mean - slope / squares * (static_cast<double>(j) - middle));
      sum += std::norm(taps[j]);
    }
    norm = std::sqrt(sum);
    for (Complex& tap : taps) tap /= norm;
  }
  std::size_t size() const { return 2 * reach_lines + 1; }

  Complex response(const Whitened& of, std::size_t centre) const {
    const Complex* at = of.residual.data() + centre - reach_lines;
    Complex sum = 0.0;
    for (std::size_t j = 0; j < size(); ++j) sum += taps[j] * at[j];
    return sum;
  }
  /// Σ|residual|² about the centre, less that of its straight line.
  double scatter(const Whitened& of, std::size_t centre) const {
    const std::size_t first = centre - reach_lines, last = centre + reach_lines + 1;
    const double n = static_cast<double>(size()), half = static_cast<double>(reach_lines);
    const Complex sum = of.sum[last] - of.sum[first];
    const Complex moment = of.moment[last] - of.moment[first] - static_cast<double>(centre) * sum;
    return of.square[last] - of.square[first] - std::norm(sum) / n - std::norm(moment) * 3.0 / (half * (half + 1.0) * n);
  }
};

struct PeakCandidate {
  double growth = 0.0, significance = 0.0;
  std::size_t filter = 0, centre = 0;
  double noise = 1.0;  ///< mean square of the scatter about it
};

std::vector<PeakFilter> filters_of(std::size_t lines) {
  std::vector<PeakFilter> out;
  const double widest = std::max(4.0, static_cast<double>(lines) / lines_per_width);
  for (double h = narrowest; h <= widest; h *= widening) {
    out.emplace_back(h, 0.0);
    if (h < 2.0) out.emplace_back(h, 0.5);
  }
  std::erase_if(out, [&](const PeakFilter& filter) { return filter.size() > lines; });
  return out;
}

/// Where the sum over FRFs of one filter's responses is largest among its neighbours and above the quantile.
std::vector<PeakCandidate> candidates_of(const std::vector<Whitened>& frfs, const PeakFilter& filter, std::size_t index) {
  const std::size_t lines = frfs.front().residual.size();
  const std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(filter.half_width / 2.0));
  const double count = static_cast<double>(frfs.size()), free = 2.0 * count * (static_cast<double>(filter.size()) - 3.0);
  const double quantile = chi_square_quantile(2.0 * count + 2.0, significance_deviations);
  std::vector<PeakCandidate> all;
  for (std::size_t centre = filter.reach_lines; centre + filter.reach_lines < lines; centre += step) {
    double growth = 0.0, scatter = 0.0;
    for (const Whitened& frf : frfs) {
      growth += std::norm(filter.response(frf, centre));
      scatter += filter.scatter(frf, centre);
    }
    const double noise = std::max(1.0, (scatter - growth) / free);
    all.push_back({growth, growth / (quantile * noise), index, centre, noise});
  }
  std::vector<PeakCandidate> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool above = all[i].significance > 1.0 && (i == 0 || all[i].growth >= all[i - 1].growth) &&
                       (i + 1 == all.size() || all[i].growth > all[i + 1].growth);
    if (above) out.push_back(all[i]);
  }
  return out;
}

/// |residual|² of the second highest line within two of the centre.
double second_line(const Whitened& frf, std::size_t centre) {
  std::vector<double> squares;
  for (std::size_t i = centre - 2; i <= centre + 2; ++i) squares.push_back(std::norm(frf.residual[i]));
  std::ranges::nth_element(squares, squares.begin() + 1, std::greater{});
  return squares[1];
}

bool is_prominent(const std::vector<Whitened>& frfs, const PeakFilter& filter, const PeakCandidate& of) {
  const double least = chi_square_quantile(2.0, significance_deviations) * of.noise;
  return std::ranges::any_of(frfs, [&](const Whitened& frf) {
    const double height = std::abs(filter.response(frf, of.centre));
    return height * height > least && height / filter.norm > standing_out * frf.terms[of.centre] && second_line(frf, of.centre) > two_lines;
  });
}

}  // namespace

std::vector<ResidualPeak> residual_peaks(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind,
                                         const std::vector<Pole>& poles) {
  std::vector<Whitened> frfs(entries.size());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) { frfs[k] = whitened(band, entries[k], kind, poles); });
  const std::vector<PeakFilter> filters = filters_of(band.lines());
  std::vector<std::vector<PeakCandidate>> of_filter(filters.size());
  tbb::parallel_for(std::size_t{0}, filters.size(), [&](std::size_t i) { of_filter[i] = candidates_of(frfs, filters[i], i); });
  std::vector<PeakCandidate> all;
  for (const auto& each : of_filter) all.insert(all.end(), each.begin(), each.end());
  std::ranges::stable_sort(all, std::greater{}, &PeakCandidate::growth);
  const double spacing = (band.frequency_hz.back() - band.frequency_hz.front()) / static_cast<double>(band.lines() - 1);
  std::vector<ResidualPeak> out;
  for (const PeakCandidate& each : all) {
    if (out.size() >= most_peaks) break;
    const PeakFilter& filter = filters[each.filter];
    const double f = band.frequency_hz[each.centre] + filter.offset * spacing, width = filter.half_width * spacing;
    const auto near = [&](const Pole& pole, double times) {
      return std::abs(f - pole.frequency_hz) < times * (width + half_width_hz(kind, pole));
    };
    if (std::ranges::any_of(poles, [&](const Pole& pole) { return near(pole, 3.0); })) continue;
    if (std::ranges::any_of(out, [&](const ResidualPeak& peak) { return near(peak.pole, 6.0); })) continue;
    if (!is_prominent(frfs, filter, each)) continue;
    out.push_back({{f, width / f * damping_per_zeta(kind)}, each.growth, each.significance});
  }
  return out;
}

}  // namespace jointid::modalfit
