#include "ident/linear/rounding_judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>

#include "restrictions/impedance_factor.hpp"
#include "restrictions/unit.hpp"

namespace jointid::ident {
namespace {

constexpr double worth_a_warning = 1e-2, unusable = 1.0;

/// Relative error of an FRF: as stored, and one more rounding when it was brought to receptance.
double frf_error(const Plan& plan) {
  double stored = 0.0;
  for (const frf::FrfSystem* system : {plan.substructures.get(), plan.assembly.get()}) {
    for (std::size_t s = 0; s < system->source_count(); ++s) stored = std::max(stored, system->source(s).header().precision);
  }
  return stored + 0x1p-53;
}

/// Σ|S∘T_k| per unknown of the restriction.
std::vector<double> column_errors(const Plan& plan, const RoundingScale& scale) {
  std::vector<double> errors(plan.restriction.unknowns.size(), 0.0);
  for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
    for (const restrictions::Term& term : matrix.terms) {
      errors[term.unknown] += scale.coefficient(term.row, term.column) * std::abs(term.coefficient);
    }
  }
  return errors;
}

double known_errors(const Plan& plan, const RoundingScale& scale) {
  double sum = 0.0;
  for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
    for (const restrictions::Known& known : matrix.known) {
      sum += scale.coefficient(known.row, known.column) * std::abs(known.value) / unscale(matrix.kind, plan.omega0);
    }
  }
  return sum;
}

/// |δy_j| of every column, in scaled unknowns.
std::vector<double> bounds(const Plan& plan, const minimise::LinearSolution& linear, const RoundingScale& scale) {
  const std::vector<double> of_unknown = column_errors(plan, scale);
  double moved = known_errors(plan, scale), amplified = 0.0;
  for (std::size_t j = 0; j < linear.y.size(); ++j) {
    const double of_column = of_unknown[plan.columns->unknown_of(j)];
    moved += of_column * std::abs(linear.y[j]);
    amplified += of_column * linear.inverse_norms[j];
  }
  const double error = frf_error(plan), lost = 2.0 * error * amplified;
  const double total = error * (scale.right() + 2.0 * moved + 2.0 * linear.residual_norm * amplified);
  std::vector<double> out = linear.rounding;
  for (std::size_t j = 0; j < out.size(); ++j) {
    out[j] += linear.inverse_norms[j] * total;
    out[j] = lost < 1.0 ? out[j] / (1.0 - lost) : std::numeric_limits<double>::infinity();
  }
  return out;
}

/// Joint and power of length of every unknown of the restriction: what can be compared in size when scaled.
std::vector<std::pair<std::size_t, int>> dimensions(const Plan& plan) {
  std::vector<std::pair<std::size_t, int>> out(plan.restriction.unknowns.size());
  for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
    for (const restrictions::Term& term : matrix.terms) {
      const int power = restrictions::length_power(plan.restriction.dofs[term.row], plan.restriction.dofs[term.column]);
      out[term.unknown] = {plan.restriction.unknowns[term.unknown].joint, power};
    }
  }
  return out;
}

/// Bounds over the largest unknown of the same joint and unit.
std::vector<double> relative(const Plan& plan, const std::vector<double>& y, const std::vector<double>& bound) {
  const auto dimension = dimensions(plan);
  const auto of = [&](std::size_t j) { return dimension[plan.columns->unknown_of(j)]; };
  std::map<std::pair<std::size_t, int>, double> largest;
  for (std::size_t j = 0; j < y.size(); ++j) largest[of(j)] = std::max(largest[of(j)], std::abs(y[j]));
  std::vector<double> out;
  for (std::size_t j = 0; j < y.size(); ++j) out.push_back(bound[j] == 0.0 ? 0.0 : bound[j] / largest[of(j)]);
  for (double& share : out) share = std::isnan(share) ? std::numeric_limits<double>::infinity() : share;
  return out;
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "any multiple";
  std::ostringstream text;
  text.precision(2);
  share < 10.0 ? text << 100.0 * share << " %" : text << share << " times";
  return text.str();
}

std::string remedy(const Plan& plan) {
  if (plan.solver == Solver::normal) return "Use solver \"qr\", which does not square the condition number.";
  if (!takes_frfs_as_measured(plan.scene.identify.method)) return "Method \"one\" does not invert measured FRFs.";
  return "Choose lines and coordinates where the joint moves more, or name fewer unknowns (springs, known entries).";
}

/// "Rounding alone can move K(1,1), K(1,2) and 3 more by up to 4 % of the largest unknown of their unit."
std::string sentence(const Plan& plan, const std::vector<double>& share, double threshold) {
  std::vector<std::size_t> order(share.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t j) { return share[j] <= threshold; });
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
  constexpr std::size_t most = 4;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, order.size()); ++i) {
    names += (i > 0 ? ", " : "") + plan.columns->name(order[i], plan.restriction);
  }
  if (order.size() > most) names += " and " + std::to_string(order.size() - most) + " more";
  return "Rounding alone can move " + names + " by up to " + percent(share[order.front()]) +
         " of the largest unknown of that unit. " + remedy(plan);
}

}  // namespace

void judge_rounding(const Plan& plan, const minimise::LinearSolution& linear, const RoundingScale& scale, Solution& out) {
  if (linear.rounding.empty()) return;
  const std::vector<double> bound = bounds(plan, linear, scale);
  for (std::size_t j = 0; j < bound.size(); ++j) out.unknowns[j].rounding = bound[j] * plan.unscale(j);
  const std::vector<double> share = relative(plan, linear.y, bound);
  const double worst = *std::ranges::max_element(share);
  out.fit.digits = worst > 0.0 ? std::max(0.0, -std::log10(worst)) : 16.0;
  if (!(worst <= unusable)) {
    out.status = Status::imprecise;
    out.message = sentence(plan, share, unusable);
  } else if (worst > worth_a_warning) {
    out.warnings.push_back(sentence(plan, share, worth_a_warning));
  }
}

}  // namespace jointid::ident
