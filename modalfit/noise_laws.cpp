#include "modalfit/noise_laws.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "modalfit/normal_block.hpp"

namespace jointid::modalfit {
namespace {

using Complex = std::complex<double>;

/// Observed squares and the two shapes that explain them.
struct Squares {
  std::vector<double> observed, relative, constant;
};

Squares squares_of(const Band& band, std::size_t entry, const Eigen::VectorXd& fitted, double freedom_share) {
  Squares out;
  for (std::size_t i = 0; i < band.lines(); ++i) {
    if (band.weights(entry)[2 * i] == 0.0) continue;
    const auto row = static_cast<Eigen::Index>(2 * i);
    const Complex model(fitted(row), fitted(row + 1));
    out.observed.push_back(0.5 * std::norm(band.value(entry)[i] - model) / freedom_share);
    out.relative.push_back(std::norm(model));
    out.constant.push_back(std::norm(frf::to_receptance(band.quantity, band.frequency_hz[i])));
  }
  return out;
}

struct Law {
  double relative = 0.0, constant = 0.0;
};

/// Multiplicative updates that never lower the likelihood of exponential squares (Itakura–Saito; Févotte & Idier 2011).
Law fit_law(const Squares& squares) {
  double observed = 0.0, relative = 0.0, constant = 0.0;
  for (std::size_t i = 0; i < squares.observed.size(); ++i) {
    observed += squares.observed[i];
    relative += squares.relative[i];
    constant += squares.constant[i];
  }
  Law law{0.5 * observed / relative, 0.5 * observed / constant};
  for (int iteration = 0; iteration < 60; ++iteration) {
    double up_r = 0.0, down_r = 0.0, up_c = 0.0, down_c = 0.0;
    for (std::size_t i = 0; i < squares.observed.size(); ++i) {
      const double variance = law.relative * squares.relative[i] + law.constant * squares.constant[i];
      const double excess = squares.observed[i] / (variance * variance);
      up_r += squares.relative[i] * excess;
      down_r += squares.relative[i] / variance;
      up_c += squares.constant[i] * excess;
      down_c += squares.constant[i] / variance;
    }
    law.relative *= std::sqrt(up_r / down_r);
    law.constant *= std::sqrt(up_c / down_c);
  }
  return law;
}

void set_weights(Band& band, std::size_t entry, const Eigen::VectorXd& fitted, const Law& law) {
  double* weight = band.weights(entry);
  for (std::size_t i = 0; i < band.lines(); ++i) {
    if (weight[2 * i] == 0.0) continue;
    const auto row = static_cast<Eigen::Index>(2 * i);
    const double variance = law.relative * (fitted(row) * fitted(row) + fitted(row + 1) * fitted(row + 1)) +
                            law.constant * std::norm(frf::to_receptance(band.quantity, band.frequency_hz[i]));
    const double least = 1e-12 * std::abs(band.value(entry)[i]);
    weight[2 * i] = weight[2 * i + 1] = 1.0 / std::max(std::sqrt(variance), least);
  }
}

}  // namespace

void estimate_noise(Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles) {
  const RealBasis basis(make_basis(kind, poles, band.frequency_hz, band.scale_hz(), false));
  tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t k) {
    const NormalBlock block(basis, band, entries[k]);
    const double free = block.equations() - static_cast<double>(basis.columns.cols());
    if (free <= 0.0) return;
    const Eigen::VectorXd fitted = basis.columns * block.coefficients();
    set_weights(band, entries[k], fitted, fit_law(squares_of(band, entries[k], fitted, free / block.equations())));
  });
}

}  // namespace jointid::modalfit
