#include "friction/law/generalized_slip.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

void check(bool valid, std::size_t point, const char* text) {
  if (!valid) refuse("generalised slip: point " + std::to_string(point + 1) + ": " + text);
}

/// The share where the stretch from p to q reaches u, p.displacement ≤ u < q.displacement.
double share_between(const SlipPoint& p, const SlipPoint& q, double u) {
  return p.share + (q.share - p.share) * ((u - p.displacement) / (q.displacement - p.displacement));
}

}  // namespace

GeneralizedSlip::GeneralizedSlip(double stiffness, std::vector<SlipPoint> table)
    : stiffness_(stiffness), table_(std::move(table)) {
  if (!(stiffness_ > 0.0) || !std::isfinite(stiffness_)) {
    refuse("generalised slip: stiffness " + std::to_string(stiffness_) + " must be finite and > 0");
  }
  if (table_.empty()) refuse("generalised slip: no points");
  for (std::size_t i = 0; i < table_.size(); ++i) {
    check(i > 0 || table_[i].share == 0.0, i, "the first share must be 0");
    check(i == 0 || table_[i].share > table_[i - 1].share, i, "shares must increase");
    check(table_[i].share <= 1.0, i, "shares are at most 1");
    check(table_[i].displacement > 0.0 && std::isfinite(table_[i].displacement), i, "displacements must be finite and > 0");
    check(i == 0 || table_[i].displacement >= table_[i - 1].displacement, i, "displacements must not decrease");
  }
}

template <class Figure>
double GeneralizedSlip::slipped(double u, Figure figure) const {
  double sum = 0.0;
  for (std::size_t i = 1; i < table_.size() && table_[i - 1].displacement <= u; ++i) {
    const SlipPoint &p = table_[i - 1], &q = table_[i];
    if (q.displacement <= u) {
      sum += (q.share - p.share) * figure(p.displacement, q.displacement);
    } else {
      sum += (share_between(p, q, u) - p.share) * figure(p.displacement, u);
    }
  }
  return sum;
}

double GeneralizedSlip::share(double u) const {
  const auto next = std::ranges::upper_bound(table_, u, {}, &SlipPoint::displacement);
  if (next == table_.begin()) return 0.0;
  return next == table_.end() ? table_.back().share : share_between(*(next - 1), *next, u);
}

Response GeneralizedSlip::response(double u) const {
  const double stick = 1.0 - share(u), first = slipped(u, [](double p, double q) { return 0.5 * (p + q); });
  return {stiffness_ * (stick > 0.0 ? first + stick * u : first), stiffness_ * stick};
}

double GeneralizedSlip::energy(double u) const {
  const double gone = slipped(u, [u](double p, double q) { return 0.5 * (p + q) * u - (p * p + p * q + q * q) / 6.0; });
  return stiffness_ * (gone + 0.5 * (1.0 - share(u)) * u * u);
}

/// Every slider gives 4u(h)(u − u(h)).
double GeneralizedSlip::cycle_energy(double u) const {
  return 4.0 * stiffness_ * slipped(u, [u](double p, double q) {
           return (2.0 * p * (u - p) + p * (u - q) + q * (u - p) + 2.0 * q * (u - q)) / 6.0;
         });
}

double GeneralizedSlip::second_moment(double u) const {
  const double u3 = u * u * u;
  const double gone = slipped(u, [u3](double p, double q) {
    const double fourth = (p * p * p * p + p * p * p * q + p * p * q * q + p * q * q * q + q * q * q * q) / 5.0;
    return 0.5 * (p + q) * u3 / 3.0 - fourth / 12.0;
  });
  return stiffness_ * (gone + 0.25 * (1.0 - share(u)) * u3 * u);
}

double GeneralizedSlip::limit() const {
  if (table_.back().share < 1.0) return infinity;
  return response(table_.back().displacement).force;
}

std::vector<double> GeneralizedSlip::kinks() const {
  std::vector<double> all;
  for (const SlipPoint& point : table_) {
    if (all.empty() || point.displacement > all.back()) all.push_back(point.displacement);
  }
  return all;
}

std::vector<Parameter> GeneralizedSlip::parameters() const {
  std::vector<Parameter> result = {{.name = "k", .unit = "N/m", .value = stiffness_}};
  for (std::size_t i = 0; i < table_.size(); ++i) {
    result.push_back({.name = "u" + std::to_string(i), .unit = "m", .value = table_[i].displacement});
  }
  return result;
}

/// ∂T/∂u_i = k∫ over the slipped shares of the hat function of point i.
void GeneralizedSlip::derivative(double u, std::span<double> out) const {
  std::ranges::fill(out, 0.0);
  out[0] = response(u).force / stiffness_;
  for (std::size_t i = 1; i < table_.size() && table_[i - 1].displacement <= u; ++i) {
    const SlipPoint &p = table_[i - 1], &q = table_[i];
    const double width = q.share - p.share;
    const double t = q.displacement <= u ? 1.0 : (u - p.displacement) / (q.displacement - p.displacement);
    out[i] += stiffness_ * width * (t - 0.5 * t * t);
    out[i + 1] += stiffness_ * width * 0.5 * t * t;
  }
}

bool GeneralizedSlip::admits(std::span<const double> values) const {
  return Element::admits(values) && std::ranges::is_sorted(values.subspan(1));
}

std::unique_ptr<Element> GeneralizedSlip::with(std::span<const double> values) const {
  if (values.size() != table_.size() + 1) {
    refuse("generalised slip: " + std::to_string(values.size()) + " values");
  }
  std::vector<SlipPoint> table = table_;
  for (std::size_t i = 0; i < table.size(); ++i) table[i].displacement = values[i + 1];
  return std::make_unique<GeneralizedSlip>(values[0], std::move(table));
}

}  // namespace jointid::friction
