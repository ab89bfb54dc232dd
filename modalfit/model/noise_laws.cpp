#include "modalfit/model/noise_laws.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "modalfit/band/normal_block.hpp"

namespace jointid::modalfit {
namespace {

constexpr double lines_per_place = 400.0;
/// An exponential square is larger once in 22,000.
constexpr double most_square = 10.0;
constexpr double least_share = 0.25, most_share = 6.0;  ///< of the variance of differences that residuals may have
constexpr int law_iterations = 60;
/// Of the moduli of a model's terms: what the arithmetic of a model, and of whatever computed the FRFs, leaves at most.
constexpr double arithmetic = 1e-9;
constexpr double digits = 0.25;  ///< rms rounding of a number over its largest

struct Law {
  double relative = 0.0, constant = 0.0;
};

/// What an entry's fit leaves, line by line.
struct Leftover {
  std::vector<Complex> residual;
  std::vector<double> relative, constant;  ///< |H|², |c|²
  std::vector<double> rounding;            ///< standard deviation below which digits end
  std::vector<bool> measured;
  double freedom_share = 1.0;

  Leftover(const Band& band, std::size_t entry, const NormalBlock& block, const RealBasis& basis, double share) : freedom_share(share) {
    const Eigen::VectorXd fitted = basis.columns * block.coefficients();
    const Eigen::VectorXd terms = basis.columns.cwiseAbs() * block.coefficients().cwiseAbs();
    for (std::size_t i = 0; i < band.lines(); ++i) {
      const auto row = static_cast<Eigen::Index>(2 * i);
      const Complex model(fitted(row), fitted(row + 1));
      residual.push_back(band.value(entry)[i] - model);
      relative.push_back(std::norm(model));
      constant.push_back(std::norm(frf::to_receptance(band.quantity, band.frequency_hz[i])));
      rounding.push_back(std::max(arithmetic * std::hypot(terms(row), terms(row + 1)), digits * band.precision * std::abs(model)));
      measured.push_back(band.weights(entry)[2 * i] > 0.0);
    }
  }
  std::size_t lines() const { return residual.size(); }
  double variance(const Law& law, std::size_t i) const { return law.relative * relative[i] + law.constant * constant[i]; }
};

/// Squared differences and what explains them.
struct Differences {
  std::vector<double> place;  ///< line
  std::vector<double> observed, relative, constant;

  explicit Differences(const Leftover& left) {
    const auto mean = [](const std::vector<double>& of, std::size_t i) { return (of[i - 1] + 4.0 * of[i] + of[i + 1]) / 6.0; };
    for (std::size_t i = 1; i + 1 < left.lines(); ++i) {
      if (!left.measured[i - 1] || !left.measured[i] || !left.measured[i + 1]) continue;
      const Complex d = left.residual[i - 1] - 2.0 * left.residual[i] + left.residual[i + 1];
      place.push_back(static_cast<double>(i));
      observed.push_back(std::norm(d) / (12.0 * left.freedom_share));
      relative.push_back(mean(left.relative, i));
      constant.push_back(mean(left.constant, i));
    }
  }
};

/// Places of laws on the lines and their hat functions.
struct Places {
  double step = 1.0;
  std::size_t count = 1;

  explicit Places(std::size_t lines) {
    const double last = static_cast<double>(lines - 1);
    const double pieces = std::round(last / lines_per_place);
    count = 1 + static_cast<std::size_t>(pieces);
    step = pieces > 0.0 ? last / pieces : 2.0 * last;
  }
  double hat(std::size_t place, double line) const {
    return count == 1 ? 1.0 : std::max(0.0, 1.0 - std::abs(line / step - static_cast<double>(place)));
  }
};

double median_ratio(const std::vector<double>& above, const std::vector<double>& below, const std::vector<double>& hat) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (hat[i] > 0.0 && below[i] > 0.0) ratios.push_back(above[i] / below[i]);
  }
  if (ratios.empty()) return 0.0;
  std::ranges::nth_element(ratios, ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2));
  return ratios[ratios.size() / 2];
}

/// Multiplicative updates that never lower the likelihood of exponential squares (Itakura–Saito; Févotte & Idier 2011), squares
/// bounded by the law so far; from half the medians.
Law fit_law(const Differences& of, const std::vector<double>& hat) {
  const double of_mean = 0.5 / std::log(2.0);
  Law law{of_mean * median_ratio(of.observed, of.relative, hat), of_mean * median_ratio(of.observed, of.constant, hat)};
  for (int iteration = 0; iteration < law_iterations; ++iteration) {
    double up_r = 0.0, down_r = 0.0, up_c = 0.0, down_c = 0.0;
    for (std::size_t i = 0; i < of.observed.size(); ++i) {
      const double variance = law.relative * of.relative[i] + law.constant * of.constant[i];
      if (hat[i] == 0.0 || !(variance > 0.0)) continue;
      const double excess = hat[i] * std::min(of.observed[i], most_square * variance) / (variance * variance);
      up_r += of.relative[i] * excess;
      down_r += hat[i] * of.relative[i] / variance;
      up_c += of.constant[i] * excess;
      down_c += hat[i] * of.constant[i] / variance;
    }
    if (down_r > 0.0) law.relative *= std::sqrt(up_r / down_r);
    if (down_c > 0.0) law.constant *= std::sqrt(up_c / down_c);
  }
  return law;
}

/// Bounded mean square of the residuals over the law, about one place.
double share_left(const Leftover& left, const Law& law, const Places& places, std::size_t place) {
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < left.lines(); ++i) {
    const double hat = places.hat(place, static_cast<double>(i)), variance = left.variance(law, i);
    if (hat == 0.0 || !left.measured[i] || !(variance > 0.0)) continue;
    sum += hat * std::min(most_square, 0.5 * std::norm(left.residual[i]) / (variance * left.freedom_share));
    count += hat;
  }
  return count > 0.0 ? std::clamp(sum / count, least_share, most_share) : 1.0;
}

std::vector<Law> laws_of(const Leftover& left, const Places& places) {
  const Differences differences(left);
  std::vector<Law> laws;
  std::vector<double> hat(differences.place.size());
  for (std::size_t place = 0; place < places.count; ++place) {
    std::ranges::transform(differences.place, hat.begin(), [&](double line) { return places.hat(place, line); });
    Law law = fit_law(differences, hat);
    const double share = share_left(left, law, places, place);
    laws.push_back({law.relative * share, law.constant * share});
  }
  return laws;
}

void set_weights(Band& band, std::size_t entry, const Leftover& left, const std::vector<Law>& laws, const Places& places) {
  double* weight = band.weights(entry);
  for (std::size_t i = 0; i < band.lines(); ++i) {
    if (!left.measured[i]) continue;
    double variance = 0.0;
    const auto piece = static_cast<std::size_t>(static_cast<double>(i) / places.step);
    const std::size_t below = places.count == 1 ? 0 : std::min(places.count - 2, piece);
    for (std::size_t place = below; place < std::min(places.count, below + 2); ++place) {
      variance += places.hat(place, static_cast<double>(i)) * left.variance(laws[place], i);
    }
    weight[2 * i] = weight[2 * i + 1] = 1.0 / std::max(std::sqrt(variance), left.rounding[i]);
  }
}

}  // namespace

void estimate_noise(Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles) {
  const RealBasis basis(make_basis(kind, poles, band.frequency_hz, band.scale_hz(), false));
  const Places places(band.lines());
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    const NormalBlock block(basis, band, entries[k]);
    const double free = block.equations() - static_cast<double>(basis.columns.cols());
    if (free <= 0.0) return;
    const Leftover left(band, entries[k], block, basis, free / block.equations());
    set_weights(band, entries[k], left, laws_of(left, places), places);
  });
}

}  // namespace jointid::modalfit
