#include "ident/admissible/outcome.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;

std::size_t count(Index n) { return static_cast<std::size_t>(n); }

std::size_t free_unknowns(const AdmissibleSet& set) { return count(set.directions.cols()); }

void cut_intervals(const std::vector<Bound>& bounds, Solution& out) {
  for (const auto& [unknown, lower, upper] : bounds) {
    const auto found = std::ranges::find(out.unknowns, unknown, &Estimate::name);
    if (!found->ci95) continue;
    for (double& end : *found->ci95) end = std::clamp(end, lower, upper);
  }
}

}  // namespace

Admissibility outcome_of(const AdmissibleSet& set, const AdmissibleFit& fit, double unit) {
  Admissibility out;
  const double scale = 1.0 / (unit * unit);
  out.chi_square = fit.cost * scale;
  if (!set.ties.empty()) {
    const std::size_t ties = count(set.offset.size()) - free_unknowns(set);
    out.constraints.push_back({comma_list(set.ties), ties, ties, fit.tie_cost * scale});
    out.equations += ties;
  }
  for (std::size_t k = 0; k < set.inequalities.size(); ++k) {
    const SymmetricBlock& block = set.inequalities[k].block;
    const std::size_t zero = count(fit.at_limit[k]);
    out.constraints.push_back({set.inequalities[k].text, count(block.size()), zero, fit.shares[k] * scale});
    out.equations += std::min(zero * (zero + 1) / 2, block.unknowns.size());
  }
  return out;
}

void tell_outcome(const Plan& plan, Solution& out) {
  const AdmissibleSet& set = *plan.admissible;
  const Admissibility& found = *out.admissibility;
  const std::size_t first = found.constraints.size() - set.inequalities.size();
  for (const Index column : set.tied) out.unknowns[count(column)].limit = "tied";
  for (std::size_t k = 0; k < set.inequalities.size(); ++k) {
    const Inequality& inequality = set.inequalities[k];
    for (const Index column : inequality.block.unknowns) {
      Estimate& estimate = out.unknowns[count(column)];
      if (found.constraints[first + k].at_limit > 0) estimate.limit = inequality.at_limit;
    }
  }
  cut_intervals(plan.scene.identify.bounds, out);
}

}  // namespace jointid::ident
