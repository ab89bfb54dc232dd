#include "friction/curve/slip_shares.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "base/error.hpp"
#include "minimise/least_value.hpp"

namespace jointid::friction {
namespace {

[[noreturn]] void no_shares(const std::string& problem, const std::string& remedy) {
  throw InputError({ErrorKind::usage, "", "slopes", problem, remedy});
}

/// y = p + q·x by least squares, and the sum of squares that is left. `through_zero`: p = 0.
struct StraightLine {
  double offset = 0.0, slope = 0.0, rest = 0.0;
};

StraightLine straight_line(const std::vector<double>& x, const std::vector<double>& y, bool through_zero) {
  const double n = static_cast<double>(x.size());
  const double mean_x = through_zero ? 0.0 : std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double mean_y = through_zero ? 0.0 : std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) xx += (x[i] - mean_x) * (x[i] - mean_x), xy += (x[i] - mean_x) * (y[i] - mean_y);
  StraightLine line;
  line.slope = xx > 0.0 ? xy / xx : 0.0;
  line.offset = mean_y - line.slope * mean_x;
  for (std::size_t i = 0; i < x.size(); ++i) line.rest += std::pow(y[i] - line.offset - line.slope * x[i], 2);
  return line;
}

/// A form u = offset + slope·g(h, s) with one parameter s inside.
using Inner = std::function<double(double h, double s)>;

struct ShapedLine {
  double shape = 0.0;
  StraightLine line;
};

/// The s between two ends, searched on a logarithmic grid and then by golden sections.
ShapedLine best_shape(const SlipShares& shares, const Inner& inner, double low, double high, bool through_zero) {
  const auto at = [&](double share) {
    const double s = low * std::pow(high / low, share);
    std::vector<double> g;
    for (const double h : shares.h) g.push_back(inner(h, s));
    return ShapedLine{s, straight_line(g, shares.u, through_zero)};
  };
  return at(least_over([&](double share) { return at(share).line.rest; }, 0.0, 1.0, 60, 1e-14));
}

/// The shares that forms are fitted to.
SlipShares between(const SlipShares& all, double low, double high) {
  SlipShares out;
  for (std::size_t i = 0; i < all.h.size(); ++i) {
    if (!(all.h[i] > low && all.h[i] < high)) continue;
    out.u.push_back(all.u[i]);
    out.h.push_back(all.h[i]);
  }
  return out;
}

std::vector<SlipForm> fitted_forms(const SlipShares& shares) {
  const double unit = shares.u.back() * std::sqrt(static_cast<double>(shares.u.size()));
  const auto rms = [unit](double rest) { return std::sqrt(rest) / unit; };
  const Inner exponential = [](double h, double s) { return std::exp(s * h); };
  const ShapedLine ren = best_shape(shares, exponential, 1e-2, 50.0, true);
  const ShapedLine offset = best_shape(shares, exponential, 1e-2, 50.0, false);
  const ShapedLine power = best_shape(shares, [](double h, double s) { return std::pow(h, s); }, 0.05, 50.0, false);
  std::vector<double> squares, logarithms;
  for (const double h : shares.h) squares.push_back(h * h), logarithms.push_back(-std::log1p(-h));
  const StraightLine square = straight_line(squares, shares.u, false), shoukry = straight_line(logarithms, shares.u, true);
  std::vector<SlipForm> forms = {
      {"ren", {ren.line.slope, ren.shape}, rms(ren.line.rest)},
      {"exponential-offset", {offset.line.slope, offset.shape, offset.line.offset}, rms(offset.line.rest)},
      {"power", {power.line.offset, power.line.slope, power.shape}, rms(power.line.rest)},
      {"square", {square.offset, square.slope}, rms(square.rest)},
      {"shoukry", {1.0 / shoukry.slope}, rms(shoukry.rest)}};
  std::ranges::stable_sort(forms, {}, &SlipForm::rms);
  return forms;
}

}  // namespace

double slip_displacement(const Element& law, double share) {
  if (!(share >= 0.0 && share < 1.0))
    throw InputError({ErrorKind::usage, "", "share", "is " + std::to_string(share), "give 0 <= h < 1"});
  const double slope = law.response(0.0).tangent * (1.0 - share);
  const auto has_slipped = [&](double u) { return law.response(u).tangent < slope; };
  double high = 1e-12;
  while (!has_slipped(high)) {
    high *= 2.0;
    if (high > 1e12) return infinity;
  }
  double low = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) break;
    (has_slipped(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

SlipShares slip_shares(const Curve& curve, const SlipShareOptions& options) {
  constexpr std::size_t least_shares = 4;
  if (curve.kind != CurveKind::loading)
    no_shares("'" + curve.name + "' is no loading curve from rest", "give the branch from rest alone: --kind loading");
  const std::size_t n = options.points;
  if (n < 2 || curve.u.size() < n + least_shares)
    no_shares("'" + curve.name + "' has " + std::to_string(curve.u.size()) + " samples",
              "slopes are taken over " + std::to_string(n) + ": give " + std::to_string(n + least_shares) + " or more");
  SlipShares all;
  std::vector<double> slopes;
  for (std::size_t i = 0; i + n <= curve.u.size(); ++i) {
    const auto from = static_cast<std::ptrdiff_t>(i), to = static_cast<std::ptrdiff_t>(i + n);
    const std::vector<double> u(curve.u.begin() + from, curve.u.begin() + to), force(curve.value.begin() + from, curve.value.begin() + to);
    slopes.push_back(straight_line(u, force, false).slope);
    all.u.push_back(std::accumulate(u.begin(), u.end(), 0.0) / static_cast<double>(n));
  }
  all.stiffness = options.stiffness.value_or(*std::ranges::max_element(slopes));
  if (!(all.stiffness > 0.0)) no_shares("'" + curve.name + "' nowhere rises", "check the sign of the force: --sign");
  for (const double slope : slopes) all.h.push_back(1.0 - slope / all.stiffness);
  const SlipShares used = between(all, 0.02, 0.98);
  if (used.h.size() < least_shares)
    no_shares("'" + curve.name + "' has " + std::to_string(used.h.size()) + " slopes between 2 and 98 % of the largest",
              "sample the bend of the curve more closely");
  all.forms = fitted_forms(used);
  return all;
}

}  // namespace jointid::friction
