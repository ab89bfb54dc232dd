#include "records/estimate/decay_correction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/eigen.hpp"
#include "dense/minimum_norm.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::records {
namespace {

constexpr std::size_t reach = 4, around = 2 * reach + 1, degree = 2, terms = 2 * degree + 1;

constexpr double least_pivot = 1e-12, pivots_of_noise = 1.0;

/// Nine FRFs continued by a step: the value, and its derivatives with respect to them.
struct Continued {
  Complex value = unknown;
  std::array<Complex, around> weight{};
};

/// B(z)/A(z) of the FRFs h at the places (j − at)/reach, A = 1 + a₁z + a₂z², at z = `step`.
/// `deviation` of h: a column of the fit that stands out of the others by no more than the noise does is left to the smallest
/// norm, so that noise makes no poles.
Continued continued(const std::array<Complex, around>& h, double deviation, std::size_t at, Complex step) {
  Eigen::MatrixXcd a(static_cast<Eigen::Index>(around), static_cast<Eigen::Index>(terms));
  double scale = 0.0;
  for (const Complex& value : h) scale = std::max(scale, std::abs(value));
  if (!(scale > 0.0)) return {};
  Eigen::VectorXcd right(static_cast<Eigen::Index>(around));
  for (std::size_t j = 0; j < around; ++j) {
    const double z = (static_cast<double>(j) - static_cast<double>(at)) / static_cast<double>(reach);
    double power = 1.0;
    for (std::size_t k = 0; k <= degree; ++k, power *= z) {
      a(jointid::at(j), jointid::at(k)) = power;
      if (k > 0) a(jointid::at(j), jointid::at(degree + k)) = -power * h[j] / scale;
    }
    right(jointid::at(j)) = h[j] / scale;
  }
  const Eigen::MatrixXcd inverse =
      dense::ComplexMinimumNorm(a, std::max(least_pivot, pivots_of_noise * deviation / scale)).pseudo_inverse();
  const Eigen::VectorXcd x = inverse * right;
  Complex numerator = 0.0, denominator = 1.0, power = 1.0;
  std::array<Complex, terms> slope{};
  for (std::size_t k = 0; k <= degree; ++k, power *= step) {
    numerator += x(jointid::at(k)) * power;
    slope[k] = power;
    if (k > 0) denominator += x(jointid::at(degree + k)) * power;
  }
  const Complex value = numerator / denominator;
  power = 1.0;
  for (std::size_t k = 0; k <= degree; ++k, power *= step) {
    slope[k] /= denominator;
    if (k > 0) slope[degree + k] = -value * power / denominator;
  }
  Continued out{scale * value, {}};
  for (std::size_t j = 0; j < around; ++j) {
    // B(z) − h A(z) = 0 there: a change of h[j] changes the right-hand side by A(z_j) of it.
    const double z = (static_cast<double>(j) - static_cast<double>(at)) / static_cast<double>(reach);
    const Complex a_here = 1.0 + x(jointid::at(degree + 1)) * z + x(jointid::at(degree + 2)) * z * z;
    for (std::size_t k = 0; k < terms; ++k) out.weight[j] += slope[k] * inverse(jointid::at(k), jointid::at(j));
    out.weight[j] *= a_here;
  }
  return out;
}

/// E[e_r e_s*] of continued values: Σ w_j w_k* ρ_(j−k) √(C_j C_k), C_j = E[e_r e_s*] on line `first` + j.
Complex covariance_of(const Continued& r, const Continued& s, const std::array<Complex, around>& c,
                      std::span<const Complex> correlation) {
  Complex sum = 0.0;
  for (std::size_t j = 0; j < around; ++j) {
    for (std::size_t k = 0; k < around; ++k) {
      const Complex rho = j >= k ? correlation[j - k] : std::conj(correlation[k - j]);
      const Complex between = 0.5 * (c[j] + c[k]);  // smooth over nine lines
      sum += r.weight[j] * std::conj(s.weight[k]) * rho * between;
    }
  }
  return sum;
}

}  // namespace

std::vector<Complex> line_correlation(std::span<const double> window, double peak) {
  std::vector<Complex> out(around);
  double sum = 0.0;
  for (std::size_t t = 0; t < window.size(); ++t) {
    const double square = window[t] * window[t];
    sum += square;
    const double turn = -2.0 * std::numbers::pi * (static_cast<double>(t) - peak) / static_cast<double>(window.size());
    for (std::size_t d = 0; d < around; ++d) out[d] += square * std::polar(1.0, turn * static_cast<double>(d));
  }
  for (Complex& rho : out) rho /= sum;
  return out;
}

void correct_decay(Estimate& estimate, std::size_t responses, double spacing_hz, double decay_time_s,
                   std::span<const Complex> correlation) {
  const Estimate windowed = estimate;
  const std::size_t lines = windowed.frf.size() / responses, pairs = frf::pair_count(responses);
  const Complex step(0.0, 1.0 / (decay_time_s * 2.0 * std::numbers::pi * spacing_hz * static_cast<double>(reach)));
  std::ranges::fill(estimate.frf, unknown);
  std::ranges::fill(estimate.variance, unknown);
  std::ranges::fill(estimate.covariance, unknown);
  std::vector<Continued> of(responses);
  for (std::size_t line = 0; line < lines && lines >= around; ++line) {
    const std::size_t first = std::min(line < reach ? 0 : line - reach, lines - around);
    const auto nine = [&](const std::vector<Complex>& from, std::size_t rows, std::size_t row) {
      std::array<Complex, around> out;
      for (std::size_t j = 0; j < around; ++j) out[j] = from[(first + j) * rows + row];
      return out;
    };
    for (std::size_t r = 0; r < responses; ++r) {
      const auto variances = nine(windowed.covariance, pairs, frf::pair_index(r, r));
      double largest = 0.0;  // what is not known does not count
      for (const Complex& variance : variances) largest = std::max(largest, std::isnan(variance.real()) ? 0.0 : variance.real());
      of[r] = continued(nine(windowed.frf, responses, r), std::sqrt(largest), line - first, step);
      estimate.frf[line * responses + r] = of[r].value;
      for (std::size_t s = 0; s <= r; ++s) {
        const std::size_t pair = frf::pair_index(r, s);
        const Complex sum = covariance_of(of[r], of[s], nine(windowed.covariance, pairs, pair), correlation);
        estimate.covariance[line * pairs + pair] = r == s ? Complex{sum.real(), 0.0} : sum;
        if (r == s) estimate.variance[line * responses + r] = 0.5 * sum.real() * Complex{1.0, 1.0};
      }
    }
  }
}

}  // namespace jointid::records
