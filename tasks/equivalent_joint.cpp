#include "tasks/equivalent_joint.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/complex.hpp"
#include "minimise/gauss_newton.hpp"

namespace jointid::tasks {
namespace {

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

/// Every FRF's √w·r and √w·dr/dh.
template <class Add>
void each_residual(const JointLines& lines, Complex h, const Add& add) {
  for (std::size_t i = 0; i < lines.a.size(); ++i) {
    const Complex d = determinant(lines, i);
    for (const auto& [value, own] : {std::pair(lines.h1[i], lines.a[i]), std::pair(lines.h3[i], lines.c[i])}) {
      const Residual each = residual(value, own, d, lines.gap[i], h);
      const double root = std::sqrt(weight_of(lines, value));
      add(root * each.r, root * each.slope);
    }
  }
}

/// Σ|r|² and Σ|dr/dh|².
struct Sums {
  double cost = 0.0, weight = 0.0;
};
Sums sums_at(const JointLines& lines, Complex h) {
  Sums out;
  each_residual(lines, h, [&](Complex r, Complex slope) {
    out.cost += std::norm(r);
    out.weight += std::norm(slope);
  });
  return out;
}

/// In u = h/start − 1, real part before imaginary: r is a holomorphic function of h.
minimise::Linearised linearised(const JointLines& lines, Complex start, Complex h) {
  const auto rows = static_cast<Eigen::Index>(4 * lines.a.size());
  minimise::Linearised out{Eigen::VectorXd(rows), Eigen::MatrixXd(rows, 2)};
  Eigen::Index row = 0;
  each_residual(lines, h, [&](Complex r, Complex by_h) {
    const Complex slope = by_h * start;
    out.residual.segment(row, 2) << r.real(), r.imag();
    out.jacobian.middleRows(row, 2) << slope.real(), -slope.imag(), slope.imag(), slope.real();
    row += 2;
  });
  return out;
}

/// The best of what single FRFs say: h = (D − value·gap)/(value − own).
Complex start(const JointLines& lines) {
  Complex best = 0.0;
  double least = std::numeric_limits<double>::infinity();
  const auto offer = [&](Complex h) {
    const double cost = sums_at(lines, h).cost;
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
  constexpr double small_step = 1e-12;  // of |h|
  EquivalentJoint out;
  const Complex from = start(lines);
  const auto at = [&](const Eigen::VectorXd& u) { return from * Complex(1.0 + u[0], u[1]); };
  const auto found = minimise::gauss_newton([&](const Eigen::VectorXd& u) { return std::optional(linearised(lines, from, at(u))); },
                                            Eigen::VectorXd::Zero(2), {.tolerance = small_step});
  const Complex h = at(found.unknowns);
  const Sums here = sums_at(lines, h);
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
  out.settled = found.converged && std::isfinite(out.stiffness) && std::isfinite(out.damping) && std::isfinite(out.misfit);
  return out;
}

}  // namespace jointid::tasks
