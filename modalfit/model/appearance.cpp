#include "modalfit/model/appearance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/lu.hpp"
#include "frf/set/quantity.hpp"
#include "modalfit/model/pole_search.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

constexpr double much_better = 0.25, follows = 0.1;
constexpr double sure = 1e6;                ///< weight of values near 1: what poles leave is the noise
constexpr double no_part = 1e-12;           ///< of the modulus: a real or imaginary part that is not there
constexpr double follows_undamped = 1e-3;   ///< deviation over modulus
constexpr std::size_t entries_to_look_at = 100, orders_to_look_at = 20, iterations_to_look = 12, largest_matrix = 40;

Complex factor(const Band& band, std::size_t line) { return frf::from_receptance(band.quantity, band.frequency_hz[line]); }

void weigh_evenly(Band& band) {
  for (std::size_t i = 0; i < band.values.size(); ++i) {
    const Complex value = band.values[i];
    const bool is_value = value != 0.0 && std::isfinite(value.real()) && std::isfinite(value.imag());
    if (!is_value) band.values[i] = 0.0;
    band.weight[2 * i] = band.weight[2 * i + 1] = is_value ? sure : 0.0;
  }
}

/// Rms residual over FRF that a short search for poles leaves, all lines of one weight.
double residual_share(Band band, const FitOptions& options) {
  weigh_evenly(band);
  const double unit = unit_of(band);
  for (Complex& value : band.values) value /= unit;
  PolyreferenceOptions search = options.polyreference;
  search.most_outputs = entries_to_look_at;
  search.orders = orders_to_look_at;
  std::vector<std::size_t> entries;
  const std::size_t step = (band.entries() + entries_to_look_at - 1) / entries_to_look_at;
  for (std::size_t e = 0; e < band.entries(); e += step) entries.push_back(e);
  std::vector<Pole> poles;
  for (const Cluster& each : cluster(polyreference_poles(band, search), {.most_damping = options.most_damping})) {
    poles.push_back({each.pole.frequency_hz, each.pole.damping * damping_per_zeta(options.kind)});
  }
  const RefinedPoles refined = refine(band, entries, options.kind, significant_poles(band, entries, options.kind, poles, std::nullopt),
                                      {.most_iterations = iterations_to_look}, options.interrupted);
  return deviation(band, entries, options.kind, refined.poles);
}

Band conjugated(Band band) {
  for (Complex& value : band.values) value = std::conj(value);
  return band;
}

/// Receptances of what is the inverse of a stored value, FRF by FRF.
Band inverted(Band band) {
  for (std::size_t i = 0; i < band.values.size(); ++i) {
    const Complex c = factor(band, i % band.lines());
    if (band.values[i] != 0.0) band.values[i] = 1.0 / (band.values[i] * c * c);
  }
  return band;
}

bool has_square_matrices(const Band& band) {
  return band.responses == band.references && band.responses > 1 && band.responses <= largest_matrix &&
         std::ranges::none_of(band.values, [](Complex value) { return value == 0.0; });
}

Band matrices_inverted(Band band) {
  const auto n = at(band.responses);
  for (std::size_t line = 0; line < band.lines(); ++line) {
    Eigen::MatrixXcd matrix(n, n);
    for (std::size_t e = 0; e < band.entries(); ++e) {
      matrix(at(e / band.references), at(e % band.references)) = band.value(e)[line] * factor(band, line);
    }
    const Eigen::MatrixXcd inverse = dense::inverse(matrix) / factor(band, line);
    for (std::size_t e = 0; e < band.entries(); ++e) {
      band.values[e * band.lines() + line] = inverse(at(e / band.references), at(e % band.references));
    }
  }
  return band;
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

/// Whether all values of the stored quantity lack one of their parts.
bool lacks(const Band& band, double (*part)(const Complex&)) {
  for (std::size_t i = 0; i < band.values.size(); ++i) {
    const Complex stored = band.values[i] * factor(band, i % band.lines());
    if (std::abs(part(stored)) > no_part * std::abs(stored)) return false;
  }
  return true;
}

}  // namespace

void explain(ModalFit& fit, const Band& band, const FitOptions& options) {
  if (is_usable(fit.status) || (options.interrupted && options.interrupted())) return;
  const double as_is = residual_share(band, options);
  const auto is_better = [&](double other) { return other < follows && other < much_better * as_is; };
  if (const double other = residual_share(conjugated(band), options); is_better(other)) {
    fit.message = fmt::format(
        "The FRFs look conjugated, the time convention being exp(−iωt): poles leave {} of them, {} of their conjugates. "
        "Change the sign of the imaginary part.",
        percent(as_is), percent(other));
    return;
  }
  double other = residual_share(inverted(band), options);
  if (!is_better(other) && has_square_matrices(band)) other = residual_share(matrices_inverted(band), options);
  if (!is_better(other)) return;
  fit.message = fmt::format(
      "The FRFs look inverted, force over motion (dynamic stiffness, impedance, apparent mass): poles leave {} of them, "
      "{} of their inverse. Invert them.",
      percent(as_is), percent(other));
}

bool doubt_phase(ModalFit& fit, const Band& band) {
  const bool real = lacks(band, [](const Complex& value) { return value.imag(); });
  if (!real && !lacks(band, [](const Complex& value) { return value.real(); })) return false;
  fit.message = fmt::format("The FRFs are {} throughout: magnitudes, one part of complex FRFs, or of a model without damping. A modal fit "
                            "needs real and imaginary part.", real ? "real" : "imaginary");
  if (is_usable(fit.status)) fit.status = fit.deviation < follows_undamped ? Status::doubtful : Status::poor_fit;
  return true;
}

}  // namespace jointid::modalfit
