#include "friction/curve/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/stop_scope.hpp"
#include "friction/curve/equivalent.hpp"

namespace jointid::friction {
namespace {

/// Σ factor·T(u) of one row, the odd continuation of T.
struct Term {
  double factor = 0.0, u = 0.0;
};

/// The at most two terms of a row of a loading curve or loop.
std::array<Term, 2> terms(const Curve& curve, std::size_t row, double amplitude) {
  const double u = curve.u[row];
  if (curve.kind == CurveKind::loading) return {{{u < 0.0 ? -1.0 : 1.0, std::abs(u)}, {}}};
  const double direction = row <= curve.turn ? 1.0 : -1.0;
  const double way = std::clamp(0.5 * (amplitude + direction * u), 0.0, amplitude);
  return {{{2.0 * direction, way}, {-direction, amplitude}}};
}

bool is_series(const Curve& curve) { return curve.kind == CurveKind::energy || curve.kind == CurveKind::equivalent; }

/// Numbers of one amplitude: {E}, or {k_e, d_e}.
std::vector<double> series_values(const Element& element, const Curve& curve, double amplitude) {
  const Equivalent at = equivalent(element, amplitude);
  return curve.kind == CurveKind::energy ? std::vector{at.energy} : std::vector{at.stiffness, at.damping};
}

/// Their derivatives, E being πu²d_e.
std::vector<std::vector<double>> series_derivatives(const Element& element, const Curve& curve, double amplitude) {
  EquivalentDerivative at = equivalent_derivative(element, amplitude);
  if (curve.kind == CurveKind::equivalent) return {std::move(at.stiffness), std::move(at.damping)};
  for (double& each : at.damping) each *= std::numbers::pi * amplitude * amplitude;
  return {std::move(at.damping)};
}

void require(bool holds, const Curve& curve, const char* what) {
  if (!holds) refuse((curve.name.empty() ? "curve" : curve.name) + ": " + what, "correct the curve, or leave it out");
}

bool finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// Beyond it squares and fourth powers of displacements and forces leave the range of numbers.
constexpr double largest_number = 1e30;

bool is_within(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::abs(value) <= largest_number; });
}

}  // namespace

double Curve::largest_displacement() const {
  if (kind == CurveKind::loop) return 0.5 * (u[turn] - 0.5 * (u.front() + u.back()));
  double largest = 0.0;
  for (const double each : u) largest = std::max(largest, std::abs(each));
  return largest;
}

Curve loading_curve(std::string name, Record record) {
  Curve curve;
  curve.name = std::move(name);
  curve.u = std::move(record.displacement);
  curve.value = std::move(record.force);
  return curve;
}

Curve loop_curve(std::string name, const Loop& centred) {
  Curve curve = loading_curve(std::move(name), centred.record);
  curve.kind = CurveKind::loop;
  curve.turn = centred.turn;
  return curve;
}

void validate(const Curve& curve) {
  require(!curve.u.empty(), curve, "there are no samples");
  require(curve.value.size() == curve.u.size(), curve, "displacements and forces are not equally many");
  require(curve.damping.size() == (curve.kind == CurveKind::equivalent ? curve.u.size() : 0), curve,
          "stiffnesses and dampings are not equally many");
  require(finite(curve.u) && finite(curve.value) && finite(curve.damping), curve, "a number is not finite");
  require(is_within(curve.u) && is_within(curve.value) && is_within(curve.damping), curve, "a number is above 1e30");
  require(!is_series(curve) || std::ranges::all_of(curve.u, [](double u) { return u > 0.0; }), curve, "an amplitude is not positive");
  require(!is_series(curve) || std::ranges::all_of(curve.u, [](double u) { return u > 1.0 / largest_number; }), curve,
          "an amplitude is below 1e-30");
  require(curve.kind != CurveKind::loop || (curve.turn > 0 && curve.turn + 1 < curve.u.size()), curve, "a loop has no two branches");
  require(curve.largest_displacement() > 0.0, curve, "there is no displacement");
  require(curve.largest_displacement() > 1.0 / largest_number, curve, "no displacement is above 1e-30");
  require(std::ranges::any_of(curve.value, [](double value) { return std::abs(value) > 1.0 / largest_number; }), curve,
          "all values are zero");
  require(!curve.normal_load || *curve.normal_load > 0.0, curve, "the normal load is not positive");
}

std::vector<double> predicted(const Element& element, const Curve& curve) {
  stop_point();
  std::vector<double> out(curve.rows());
  if (is_series(curve)) {
    const std::size_t amplitudes = curve.u.size();
    for (std::size_t i = 0; i < amplitudes; ++i) {
      const std::vector<double> values = series_values(element, curve, curve.u[i]);
      for (std::size_t k = 0; k < values.size(); ++k) out[i + k * amplitudes] = values[k];
    }
    return out;
  }
  const double amplitude = curve.largest_displacement(), end = element.response(amplitude).force;
  for (std::size_t row = 0; row < out.size(); ++row) {
    const auto [first, second] = terms(curve, row, amplitude);
    out[row] = first.factor * element.response(first.u).force + second.factor * end;
  }
  return out;
}

std::vector<double> predicted_derivative(const Element& element, const Curve& curve) {
  stop_point();
  const std::size_t parameters = element.parameters().size();
  std::vector<double> out(curve.rows() * parameters);
  if (is_series(curve)) {
    const std::size_t amplitudes = curve.u.size();
    for (std::size_t i = 0; i < amplitudes; ++i) {
      const auto rows = series_derivatives(element, curve, curve.u[i]);
      for (std::size_t k = 0; k < rows.size(); ++k)
        std::ranges::copy(rows[k], out.begin() + static_cast<std::ptrdiff_t>((i + k * amplitudes) * parameters));
    }
    return out;
  }
  const double amplitude = curve.largest_displacement();
  std::vector<double> end(parameters);
  element.derivative(amplitude, end);
  for (std::size_t row = 0; row < curve.rows(); ++row) {
    const auto [first, second] = terms(curve, row, amplitude);
    const std::span<double> line(out.data() + row * parameters, parameters);
    element.derivative(first.u, line);
    for (std::size_t i = 0; i < parameters; ++i) line[i] = first.factor * line[i] + second.factor * end[i];
  }
  return out;
}

}  // namespace jointid::friction
