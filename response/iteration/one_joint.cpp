#include "response/iteration/one_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace jointid::response {
namespace {

/// A root between low and high, where `of` changes its sign, to rounding: Brent's method.
template <class Of>
double bracketed_root(const Of& of, double low, double high) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double a = low, b = high, fa = of(a), fb = of(b), c = a, fc = fa, step = b - a, before = step;
  for (int i = 0; i < 200 && fb != 0.0; ++i) {
    if ((fb > 0.0) == (fc > 0.0)) {
      c = a;
      fc = fa;
      step = before = b - a;
    }
    if (std::abs(fc) < std::abs(fb)) {
      a = b;
      fa = fb;
      std::swap(b, c);
      std::swap(fb, fc);
    }
    const double tolerance = 2.0 * epsilon * std::abs(b), middle = 0.5 * (c - b);
    if (std::abs(middle) <= tolerance) break;
    if (std::abs(before) >= tolerance && std::abs(fa) > std::abs(fb)) {
      const double s = fb / fa;
      double p = 2.0 * middle * s, q = 1.0 - s;
      if (a != c) {
        const double r = fb / fc, t = fa / fc;
        p = s * (2.0 * middle * t * (t - r) - (b - a) * (r - 1.0));
        q = (t - 1.0) * (r - 1.0) * (s - 1.0);
      }
      if (p > 0.0) q = -q;
      p = std::abs(p);
      const bool inside = 2.0 * p < std::min(3.0 * middle * q - std::abs(tolerance * q), std::abs(before * q));
      before = inside ? step : middle;
      step = inside ? p / q : middle;
    } else {
      before = step = middle;
    }
    a = b;
    fa = fb;
    b += std::abs(step) > tolerance ? step : std::copysign(tolerance, middle);
    fb = of(b);
  }
  return b;
}

}  // namespace

OneJointSolution one_joint(const CondensedEquations& equations, const HarmonicLine& line, double level) {
  OneJointSolution found;
  found.applies = equations.joints().size() == 1 && equations.harmonics().size() == 1 && equations.harmonics()[0] > 0;
  if (!found.applies) return found;
  const Joint& joint = equations.joints().front().joint();
  const Complex g = line.harmonics.front().joints(0, 0), b = level * line.harmonics.front().driven(0);
  const auto moved = [&](Complex q) { return equations.pack(Eigen::MatrixXcd::Constant(1, 1, q)); };
  const auto force_at = [&](double amplitude) {
    ++found.evaluations;
    return equations.forces(line.omega, moved(amplitude))(0, 0);
  };
  const auto excess = [&](double amplitude) {
    return amplitude > 0.0 ? std::abs(amplitude + g * force_at(amplitude)) - std::abs(b) : -std::abs(b);
  };
  double low = 0.0, high = std::abs(b);
  if (joint.cubic == 0.0) {
    const double stuck = std::abs(Complex(joint.stuck_stiffness(), equations.harmonics()[0] * line.omega * joint.damping));
    low = std::abs(b) / (1.0 + std::abs(g) * stuck);
  }
  const bool limited = joint.friction && joint.stiffness == 0.0 && joint.damping == 0.0 && joint.cubic == 0.0;
  if (limited && std::isfinite(joint.friction->limit())) {
    const double most = 4.0 * std::abs(g) * joint.friction->limit() / std::numbers::pi;
    low = std::max(low, std::abs(b) - most);
    high += most;
  }
  low *= 1.0 - 1e-12;
  high *= 1.0 + 1e-12;
  while (high > 0.0 && std::isfinite(high) && excess(high) < 0.0) high *= 2.0;
  found.amplitude = high > 0.0 ? bracketed_root(excess, low, high) : 0.0;
  const Complex turned = found.amplitude > 0.0 ? found.amplitude + g * force_at(found.amplitude) : Complex(1.0);
  found.motion = moved(found.amplitude > 0.0 ? found.amplitude * b / turned : Complex(0.0));
  return found;
}

}  // namespace jointid::response
