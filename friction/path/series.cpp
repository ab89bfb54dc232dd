#include "friction/path/series.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::friction {

Series::Series(Parts all) : Assembly(std::move(all)) {
  for (std::size_t i = 1; i < parts().size(); ++i) {
    if (parts()[i]->limit() < weakest().limit()) weakest_ = i;
  }
}

Series::Stretch Series::stretch(double v) const {
  Stretch result = {v, 1.0, weakest().response(v)};
  for (std::size_t i = 0; i < parts().size(); ++i) {
    if (i == weakest_) continue;
    const double own = parts()[i]->displacement(result.weakest.force);
    result.total += own;
    if (result.weakest.tangent > 0.0) result.slope += result.weakest.tangent / parts()[i]->response(own).tangent;
  }
  return result;
}

/// Newton between bounds that close in on the solution; bisection where Newton leaves them.
double Series::displacement_of_weakest(double u) const {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  double low = 0.0, high = u, v = u;
  for (int iteration = 0; iteration < 200 && high - low > eps * high; ++iteration) {
    const Stretch at = stretch(v);
    const double excess = at.total - u;
    if (std::abs(excess) <= eps * u) return v;
    (excess > 0.0 ? high : low) = v;
    const double newton = v - excess / at.slope;
    v = newton > low && newton < high ? newton : 0.5 * (low + high);
  }
  return v;
}

Response Series::response(double u) const {
  const Stretch at = stretch(displacement_of_weakest(u));
  return {at.weakest.force, at.weakest.tangent / at.slope};
}

std::vector<double> Series::displacements(double u) const {
  const double v = displacement_of_weakest(u), force = weakest().response(v).force;
  std::vector<double> result;
  for (const auto& part : parts()) result.push_back(part->displacement(force));
  result[weakest_] = v;
  return result;
}

/// The force is common, so ∫T du = Σ ∫T_i du_i.
double Series::energy(double u) const {
  const std::vector<double> each = displacements(u);
  double total = 0.0;
  for (std::size_t i = 0; i < each.size(); ++i) total += parts()[i]->energy(each[i]);
  return total;
}

double Series::cycle_energy(double u) const {
  const std::vector<double> each = displacements(u);
  double total = 0.0;
  for (std::size_t i = 0; i < each.size(); ++i) total += parts()[i]->cycle_energy(each[i]);
  return total;
}

double Series::displacement(double force) const {
  double total = 0.0;
  for (const auto& part : parts()) total += part->displacement(force);
  return total;
}

std::vector<double> Series::kinks() const {
  std::vector<double> all;
  for (std::size_t i = 0; i < parts().size(); ++i) {
    for (const double kink : parts()[i]->kinks()) {
      const double force = parts()[i]->response(kink).force;
      const double total = i == weakest_ ? stretch(kink).total : displacement(force);
      if (force <= limit() && std::isfinite(total)) all.push_back(total);
    }
  }
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// From Σ u_i(T, p) = u: ∂T/∂p = (∂T_i/∂p) / (T_i′ Σ_j 1/T_j′), here with both sides times T_w′.
void Series::derivative(double u, std::span<double> out) const {
  const std::vector<double> each = displacements(u);
  const Stretch at = stretch(each[weakest_]);
  const auto stretches = split(out);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    parts()[i]->derivative(each[i], stretches[i]);
    const double tangent = parts()[i]->response(each[i]).tangent;
    const double ratio = i == weakest_ ? 1.0 : at.weakest.tangent > 0.0 ? at.weakest.tangent / tangent : 0.0;
    for (double& value : stretches[i]) value *= ratio / at.slope;
  }
}

std::unique_ptr<Element> Series::with(std::span<const double> values) const {
  return std::make_unique<Series>(parts_with(values));
}

}  // namespace jointid::friction
