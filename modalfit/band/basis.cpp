#include "modalfit/band/basis.hpp"

#include <array>
#include <cmath>

#include "base/complex.hpp"

namespace jointid::modalfit {
namespace {

constexpr Complex imaginary{0.0, 1.0};

/// Values and derivatives by ln f_r and by the damping of a mode's columns at one line.
struct ModeColumns {
  std::array<Complex, 2> value, by_frequency, by_damping;
};

/// g = 1/D and its derivatives; the second column of complex hysteretic modes is i·g.
ModeColumns second_order(const ModelKind& kind, double w, double damping, double x) {
  const bool viscous = kind.damping == Damping::viscous;
  const Complex stiffness = viscous ? Complex(w * w, 2.0 * damping * w * x) : w * w * Complex(1.0, damping);
  const Complex g = 1.0 / (stiffness - x * x);
  const Complex by_frequency = -g * g * (viscous ? Complex(2.0 * w * w, 2.0 * damping * w * x) : 2.0 * stiffness);
  const Complex by_damping = -g * g * imaginary * (viscous ? 2.0 * w * x : w * w);
  return {{g, imaginary * g}, {by_frequency, imaginary * by_frequency}, {by_damping, imaginary * by_damping}};
}

/// Re R and Im R of R/(ix−λ) + R*/(ix−λ*).
ModeColumns pole_pair(double w, double zeta, double x) {
  const double root = std::sqrt(1.0 - zeta * zeta);
  const Complex lambda = w * Complex(-zeta, root);
  const Complex by_zeta = w * Complex(-1.0, -zeta / root);
  const Complex p = 1.0 / (imaginary * x - lambda), q = 1.0 / (imaginary * x - std::conj(lambda));
  const auto pair = [](Complex a, Complex b) { return std::array<Complex, 2>{a + b, imaginary * (a - b)}; };
  return {pair(p, q), pair(p * p * lambda, q * q * std::conj(lambda)), pair(p * p * by_zeta, q * q * std::conj(by_zeta))};
}

ModeColumns mode_columns(const ModelKind& kind, double w, double damping, double x) {
  const bool pair = kind.damping == Damping::viscous && !kind.real_modes;
  return pair ? pole_pair(w, damping, x) : second_order(kind, w, damping, x);
}

void fill_residuals(Basis& basis, const std::vector<double>& x) {
  Complex* at = basis.columns.data() + basis.modes * basis.per_mode * basis.lines;
  for (const Complex unit : {Complex(1.0), imaginary}) {
    for (const double line : x) *at++ = -unit / (line * line);
  }
  for (const Complex unit : {Complex(1.0), imaginary}) {
    for (std::size_t i = 0; i < x.size(); ++i) *at++ = unit;
  }
}

}  // namespace

Basis make_basis(const ModelKind& kind, const std::vector<Pole>& poles, const std::vector<double>& frequency_hz, double scale_hz,
                 bool with_derivatives) {
  Basis basis{.lines = frequency_hz.size(), .modes = poles.size(), .per_mode = kind.real_modes ? 1u : 2u, .columns = {}, .derivatives = {}};
  std::vector<double> x;
  for (const double f : frequency_hz) x.push_back(f / scale_hz);
  basis.columns.resize(basis.size() * basis.lines);
  if (with_derivatives) basis.derivatives.resize(basis.modes * 2 * basis.per_mode * basis.lines);
  for (std::size_t mode = 0; mode < basis.modes; ++mode) {
    const double w = poles[mode].frequency_hz / scale_hz;
    for (std::size_t line = 0; line < basis.lines; ++line) {
      const ModeColumns at = mode_columns(kind, w, poles[mode].damping, x[line]);
      for (std::size_t own = 0; own < basis.per_mode; ++own) {
        basis.columns[(mode * basis.per_mode + own) * basis.lines + line] = at.value[own];
        if (!with_derivatives) continue;
        const std::size_t first = (mode * 2 * basis.per_mode + own) * basis.lines + line;
        basis.derivatives[first] = at.by_frequency[own];
        basis.derivatives[first + basis.per_mode * basis.lines] = at.by_damping[own];
      }
    }
  }
  fill_residuals(basis, x);
  return basis;
}

double residue_scale(const ModelKind& kind, double scale_hz) {
  const double omega = angular(scale_hz);
  return kind.damping == Damping::viscous && !kind.real_modes ? omega : omega * omega;
}

}  // namespace jointid::modalfit
