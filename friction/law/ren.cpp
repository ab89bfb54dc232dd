#include "friction/law/ren.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "friction/path/cancellation_free.hpp"

namespace jointid::friction {
namespace {

constexpr std::array ren_parameters = {LawParameter{"a", "m", 0.0, infinity}, LawParameter{"b", "1", 0.0, 700.0, true},
                                          LawParameter{"k", "N/m", 0.0, infinity}};
constexpr std::array ren_shapes = {0.5, 2.0, 4.0, 7.0};

std::vector<double> ren_start(const Features& f, double b) {
  return {f.limit * b / (f.stiffness * std::expm1(b)), b, f.stiffness};
}

/// ∫₀^h e^{bη} dη.
double growth(double b, double h) { return b > 0.0 ? std::expm1(b * h) / b : h; }

}  // namespace

const Law Ren::law = {"ren", "microslip u = a exp(bh) (Ren)", ren_parameters, {ren_shapes, ren_start}};

Ren::Ren(std::span<const double> values) : ListedLaw(values) {
  begin_ = values[0];
  spread_ = values[1];
  stiffness_ = values[2];
  end_ = begin_ * std::exp(spread_);
  limit_ = stiffness_ * begin_ * growth(spread_, 1.0);
}

/// h with u(h) = u.
double Ren::slipped_share(double u) const {
  if (u < begin_) return 0.0;
  return u < end_ ? std::min(std::log1p((u - begin_) / begin_) / spread_, 1.0) : 1.0;
}

std::vector<double> Ren::kinks() const {
  if (end_ > begin_) return {begin_, end_};
  return {begin_};
}

Response Ren::response(double u) const {
  if (u >= end_) return {limit_, 0.0};
  const double h = slipped_share(u), stick = 1.0 - h;
  return {std::min(stiffness_ * (begin_ * growth(spread_, h) + stick * u), limit_), stiffness_ * stick};
}

/// k∫₀¹ ∫₀^u min(v, u(h)) dv dh: the slipped share gives u(h)(u − u(h)/2), the rest u²/2.
double Ren::energy(double u) const {
  const double h = slipped_share(u);
  const double first = begin_ * growth(spread_, h), second = begin_ * begin_ * growth(2.0 * spread_, h);
  return stiffness_ * (u * first - 0.5 * second + 0.5 * (1.0 - h) * u * u);
}

double Ren::displacement(double force) const {
  if (force <= stiffness_ * begin_) return force / stiffness_;
  return std::min(Element::displacement(force), force <= limit_ ? end_ : infinity);
}

void Ren::derivative(double u, std::span<double> out) const {
  const double h = slipped_share(u), s = spread_ * h;
  out[0] = stiffness_ * growth(spread_, h);
  out[1] = spread_ > 0.0 ? stiffness_ * begin_ * exponential_excess(s) / (spread_ * spread_)
                         : 0.5 * stiffness_ * begin_ * h;
  out[2] = begin_ * growth(spread_, h) + (1.0 - h) * u;
}

/// 2k(v − a)²/b up to macroslip, v = min(u, ae^b).
double Ren::cycle_energy(double u) const {
  if (u <= begin_) return 0.0;
  const double h = slipped_share(u), sliding = 4.0 * limit_ * std::max(u - end_, 0.0);
  const double slipped = begin_ * growth(spread_, h);
  return 2.0 * stiffness_ * spread_ * slipped * slipped + sliding;
}

double Ren::equivalent_stiffness(double u) const {
  return u <= begin_ ? stiffness_ : Element::equivalent_stiffness(u);
}

/// k∫₀¹ ∫₀^u v² min(v, u(h)) dv dh, the inner integral being u(h)u³/3 − u(h)⁴/12 in the slipped share.
double Ren::second_moment(double u) const {
  const double h = slipped_share(u), u3 = u * u * u, a4 = begin_ * begin_ * begin_ * begin_;
  const double slipped = begin_ * growth(spread_, h) * u3 / 3.0 - a4 * growth(4.0 * spread_, h) / 12.0;
  return stiffness_ * (slipped + (1.0 - h) * u3 * u / 4.0);
}

/// With s = ln(v/a): ∂T/∂a = (k/b)(v/a − 1), ∂T/∂b = (k/b²)(vs − v + a) where a < v < ae^b.
void Ren::second_moment_derivative(double u, std::span<double> out) const {
  if (spread_ < 0.05) return Element::second_moment_derivative(u, out);  // the differences below lose digits as 1/b²
  const double v = std::min(u, end_), s = spread_ * slipped_share(v), a = begin_, a4 = a * a * a * a;
  const double cubes = (v * v * v - a * a * a) / 3.0, fourths = (v * v * v * v - a4) / 4.0;
  const double sliding = (u * u * u - v * v * v) / 3.0;
  std::ranges::fill(out, 0.0);
  out[2] = second_moment(u) / stiffness_;
  if (u <= begin_) return;
  std::array<double, 3> end{};
  derivative(end_, end);
  out[0] = end[0] * sliding;
  out[1] = end[1] * sliding;
  out[0] += stiffness_ / spread_ * (fourths / a - cubes);
  out[1] += stiffness_ / (spread_ * spread_) * (v * v * v * v * s / 4.0 - 1.25 * fourths + a * cubes);
}

}  // namespace jointid::friction
