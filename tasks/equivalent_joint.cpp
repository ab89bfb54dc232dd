#include "tasks/equivalent_joint.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "base/complex.hpp"

namespace jointid::tasks {
namespace {

constexpr int most_steps = 100, most_halvings = 30;
constexpr double small_step = 1e-12;  ///< of |h|

Complex determinant(const JointLines& lines, std::size_t i) { return lines.a[i] * lines.b[i] - lines.c[i] * lines.c[i]; }

double weight_of(const JointLines& lines, Complex value) { return lines.relative ? 1.0 / std::norm(value) : 1.0; }

/// r = value − (D + own·h)/(gap + h) and dr/dh.
struct Residual {
  Complex r, slope;
};
Residual residual(Complex value, Complex own, Complex d, Complex gap, Complex h) {
  const Complex below = gap + h;
  return {value - (d + own * h) / below, (d - own * gap) / (below * below)};
}

/// Σ|r|², and the Gauss–Newton step: r is a holomorphic function of h, so both parts of h come from one complex equation.
struct HystereticStep {
  double cost = 0.0, weight = 0.0;  ///< Σ|dr/dh|²
  Complex step;
};
HystereticStep evaluate(const JointLines& lines, Complex h) {
  HystereticStep out;
  Complex pull = 0.0;
  for (std::size_t i = 0; i < lines.a.size(); ++i) {
    const Complex d = determinant(lines, i);
    for (const auto& [value, own] : {std::pair(lines.h1[i], lines.a[i]), std::pair(lines.h3[i], lines.c[i])}) {
      const Residual each = residual(value, own, d, lines.gap[i], h);
      const double w = weight_of(lines, value);
      out.cost += w * std::norm(each.r);
      pull += w * std::conj(each.slope) * each.r;
      out.weight += w * std::norm(each.slope);
    }
  }
  out.step = out.weight > 0.0 ? -pull / out.weight : Complex(0.0);
  return out;
}

/// The best of what single FRFs say: h = (D − value·gap)/(value − own).
Complex start(const JointLines& lines) {
  Complex best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](Complex h) {
    const double cost = evaluate(lines, h).cost;
    if (!(cost < least)) return;
    least = cost;
    best = h;
  };
  for (std::size_t i = 0; i < lines.a.size(); ++i) {
    const Complex d = determinant(lines, i);
    offer((d - lines.h1[i] * lines.gap[i]) / (lines.h1[i] - lines.a[i]));
    offer((d - lines.h3[i] * lines.gap[i]) / (lines.h3[i] - lines.c[i]));
  }
  return best;
}

}  // namespace

std::vector<Complex> difference_gap(const JointLines& lines) {
  std::vector<Complex> out;
  for (std::size_t i = 0; i < lines.a.size(); ++i) out.push_back(lines.a[i] + lines.b[i] - 2.0 * lines.c[i]);
  return out;
}

std::vector<Complex> rigid_gap(const JointLines& lines, const std::vector<Complex>& h1_rigid,
                               const std::vector<Complex>& h3_rigid) {
  std::vector<Complex> out;
  for (std::size_t i = 0; i < lines.a.size(); ++i) out.push_back(2.0 * determinant(lines, i) / (h1_rigid[i] + h3_rigid[i]));
  return out;
}

Complex real_frf(Complex h) { return std::copysign(std::abs(h), h.real()); }

EquivalentJoint equivalent_joint(const JointLines& lines) {
  EquivalentJoint out;
  Complex h = start(lines);
  HystereticStep here = evaluate(lines, h);
  out.settled = false;
  for (int i = 0; i < most_steps && !out.settled; ++i) {
    Complex step = here.step;
    HystereticStep next = evaluate(lines, h + step);
    for (int k = 0; k < most_halvings && !(next.cost <= here.cost); ++k) {
      step *= 0.5;
      next = evaluate(lines, h + step);
    }
    out.settled = std::abs(step) <= small_step * std::abs(h) || !(next.cost < here.cost);
    if (next.cost <= here.cost) {
      h += step;
      here = next;
    }
  }
  double size = 0.0;
  for (const auto* frf : {&lines.h1, &lines.h3}) {
    for (const Complex value : *frf) size += weight_of(lines, value) * std::norm(value);
  }
  const Complex z = 1.0 / h;
  out.stiffness = z.real();
  out.damping = z.imag();
  out.misfit = std::sqrt(here.cost / size);
  const double freedom = 4.0 * static_cast<double>(lines.a.size()) - 2.0;
  out.deviation = std::norm(z) * std::sqrt(here.cost / freedom / here.weight);
  out.settled = out.settled && std::isfinite(out.stiffness) && std::isfinite(out.damping) && std::isfinite(out.misfit);
  return out;
}

}  // namespace jointid::tasks
