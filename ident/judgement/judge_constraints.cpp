#include "ident/judgement/judge_constraints.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <string>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "dense/lu.hpp"
#include "ident/admissible/admissible_fit.hpp"
#include "ident/admissible/eigenfrequencies.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/admissible/passive_band.hpp"
#include "ident/admissible/tie.hpp"
#include "ident/judgement/measured_rectangle.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/judgement/value_scales.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double once_in_a_thousand = 1e-3, its_deviations = 3.09;

/// A constraint and its share of the cost, or what it would cost alone.
struct CostOfOne {
  std::string text, place;
  double chi_square = 0.0;
};

/// What constraints cost together.
struct ConstraintCost {
  double chi_square = 0.0;
  std::size_t equations = 0;
  std::vector<CostOfOne> each;

  bool is_above(double likely) const { return equations > 0 && chi_square > likely; }
};

void tell_cost(const ConstraintCost& cost, double likely, const std::string& errors, Solution& out) {
  const auto worst = std::ranges::max_element(cost.each, {}, &CostOfOne::chi_square);
  const std::string count = std::to_string(cost.equations) + (cost.equations == 1 ? " equation" : " equations");
  const std::string which = cost.each.size() > 1 ? "The constraint that costs most is \"" : "The constraint is \"";
  tell(out, Status::doubtful,
       "The data contradict the constraints: they raise χ² by " + digits(cost.chi_square, "%.4g") + " (" + count +
           "), where chance leaves at most " + digits(likely, "%.3g") + ", by " + errors + ". " + which + worst->text + "\"" +
           (cost.each.size() > 1 ? " (" + digits(worst->chi_square, "%.4g") + ")" : "") +
           ". Correct or remove it in the scene (" + worst->place +
           "), or find the error in the FRFs with `jointid check SCENE`.");
}

/// The inequalities of a scene are the last of the outcome, after its ties in one.
std::vector<CostOfOne> shares_of(const Plan& plan, const Admissibility& found) {
  const std::vector<Inequality>& inequalities = plan.admissible->inequalities;
  const std::size_t first = found.constraints.size() - inequalities.size();
  std::vector<CostOfOne> out;
  for (std::size_t k = 0; k < found.constraints.size(); ++k) {
    const ConstraintOutcome& each = found.constraints[k];
    const std::string ties = plan.scene.identify.frequencies_hz.empty() ? "[identify] ties" : "[identify] frequencies, ties";
    if (each.at_limit > 0) out.push_back({each.text, k < first ? ties : inequalities[k - first].place, each.chi_square});
  }
  return out;
}

/// A condition a·θ = b in units of the standard deviation of its own error.
struct WeighedCondition {
  VectorXd a;
  double b = 0.0;
  CostOfOne alone;
};

/// E|δ|² of vᵀ Re(H_bb⁻¹) v by the errors of H_bb: of its lines, δ = −(H⁻ᵀv)ᵀ δH (H⁻¹v).
double part_variance(const FrequencyCondition& condition, const MeasuredRectangle& h_bb) {
  const Index n = condition.motion.size();
  double sum = 0.0;
  for (std::size_t line = 0; line < condition.lines.size(); ++line) {
    Eigen::MatrixXcd h(n, n);
    MatrixXd variance(n, n);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(j);
        h(i, j) = h_bb.value(line, r, c);
        variance(i, j) = h_bb.variance(line, r, c);
      }
    }
    const Eigen::MatrixXcd inverse = dense::ComplexLu(h).inverse();
    const VectorXd right = (inverse * condition.motion.cast<Complex>()).cwiseAbs2();
    const VectorXd left = (inverse.transpose() * condition.motion.cast<Complex>()).cwiseAbs2();
    const double second = variance.cwiseProduct(inverse.cwiseAbs2().transpose()).sum();  // of the next order
    sum += std::pow(condition.weights[line], 2) * 0.5 * left.dot(variance * right) * (1.0 + second);
  }
  return sum;
}

/// The conditions of the stated eigenfrequencies at a joint; empty where their errors are not known.
std::optional<std::vector<WeighedCondition>> frequency_conditions(const Plan& plan, const VectorXd& theta) {
  constexpr std::size_t some = 32;
  std::vector<WeighedCondition> out;
  if (plan.scene.identify.frequencies_hz.empty()) return out;
  try {
    const Coordinates& at = plan.coordinates;
    const std::vector<Line> lines = spread_lines(plan.lines, some);
    const auto scene = scene_with_noise(plan, {at.joint, at.joint, lines_of(lines, &Line::substructures)},
                                        {at.responses, at.references, lines_of(lines, &Line::assembly)});
    if (!scene) return std::nullopt;
    for (const FrequencyCondition& each : Eigenfrequencies(plan).conditions_at(theta)) {
      const MeasuredRectangle h_bb = read_rectangle(*plan.substructures, at.joint, at.joint, *scene, each.lines);
      const double error = std::sqrt(part_variance(each, h_bb) + each.rough * each.rough + 1e-12 * each.value * each.value);
      if (!(error > 0.0) || !std::isfinite(error)) return std::nullopt;
      out.push_back({each.coefficients / error,
                     each.value / error,
                     {plain_number(each.frequency_hz) + " Hz is an eigenfrequency", "[identify] frequencies"}});
    }
  } catch (const InputError&) {
    return std::nullopt;  // no variances
  }
  return out;
}

/// The free estimate with frequencies as observations, each with its own error.
struct Observed {
  VectorXd theta;
  MatrixXd information;
  double cost = 0.0;
};

Observed observed(const VectorXd& theta, const MatrixXd& information, const std::vector<WeighedCondition>& conditions) {
  Observed out{.theta = theta, .information = information};
  if (conditions.empty()) return out;
  VectorXd gradient = information * theta;
  for (const WeighedCondition& each : conditions) {
    out.information += each.a * each.a.transpose();
    gradient += each.b * each.a;
  }
  out.theta = minimise::covariance_of(out.information) * gradient;
  const VectorXd moved = out.theta - theta;
  out.cost = moved.dot(information * moved);
  for (const WeighedCondition& each : conditions) out.cost += std::pow(each.a.dot(out.theta) - each.b, 2);
  return out;
}

/// The covariance of an estimate, with a thousandth of every unknown.
MatrixXd with_least_errors(const Plan& plan, const FreeEstimate& free) {
  constexpr double least = 1e-3, least_value = 0.1;
  const VectorXd largest = largest_of_kind(plan, free.theta);
  MatrixXd out = free.cautious;
  for (Index c = 0; c < out.rows(); ++c) {
    const double size = std::max(std::abs(free.theta[static_cast<std::size_t>(c)]), least_value * largest[c]);
    out(c, c) += std::pow(least * size, 2);
  }
  return out;
}

/// What each tie would cost alone.
std::vector<CostOfOne> ties_alone(const Plan& plan, const VectorXd& theta, const MatrixXd& covariance) {
  std::vector<std::string> names;
  for (std::size_t c = 0; c < plan.columns->size(); ++c) names.push_back(plan.columns->name(c, plan.restriction));
  std::vector<CostOfOne> out;
  for (const std::string& text : plan.admissible->ties) {
    Tie tie = parse_tie(text, names);
    for (Index c = 0; c < theta.size(); ++c) tie.coefficients[c] *= plan.unscale(static_cast<std::size_t>(c));
    const double apart = tie.coefficients.dot(theta) - tie.value;
    out.push_back({text, "[identify] ties", apart * apart / tie.coefficients.dot(covariance * tie.coefficients)});
  }
  return out;
}

/// What the constraints cost a free estimate; empty where that cannot be told.
std::optional<ConstraintCost> cost_of(const Plan& plan, const FreeEstimate& free, const VectorXd& theta) {
  const VectorXd estimate = Eigen::Map<const VectorXd>(free.theta.data(), at(free.theta.size()));
  const MatrixXd covariance = with_least_errors(plan, free);
  if (!estimate.allFinite() || !covariance.allFinite()) return std::nullopt;
  auto conditions = frequency_conditions(plan, theta);
  if (!conditions) return std::nullopt;
  const Observed from = observed(estimate, minimise::covariance_of(covariance), *conditions);
  const AdmissibleFit fit = nearest_admissible(*plan.admissible, from.theta, minimise::root_of(from.information), 1.0);
  const Admissibility found = outcome_of(*plan.admissible, fit, 1.0);
  ConstraintCost out{.chi_square = from.cost + fit.cost, .equations = found.equations + conditions->size(), .each = {}};
  if (!fit.converged || !std::isfinite(out.chi_square)) return std::nullopt;
  out.each = shares_of(plan, found);
  if (!plan.admissible->ties.empty()) {
    out.each.erase(out.each.begin());
    for (CostOfOne& each : ties_alone(plan, estimate, covariance)) out.each.push_back(std::move(each));
  }
  for (WeighedCondition& each : *conditions) {
    const double apart = each.a.dot(estimate) - each.b;
    each.alone.chi_square = apart * apart / (1.0 + each.a.dot(covariance * each.a));
    out.each.push_back(std::move(each.alone));
  }
  return out;
}

/// Doubtful where equalities at stated eigenfrequencies move an unknown, by the noise of the substructures there, further than
/// its error: the data do not contradict such a frequency, but the joint that has it exactly is worse than one without. `own`:
/// the unknowns of the method without constraints; empty: not known.
void judge_frequencies(const Plan& plan, const FreeEstimate& free, const std::vector<double>& own,
                       const std::vector<double>& theta, Solution& out) {
  constexpr double most_deviations = 5.0;
  if (plan.scene.identify.frequencies_hz.empty()) return;
  const MatrixXd covariance = with_least_errors(plan, free);
  double worst = most_deviations;
  std::size_t of = theta.size();
  for (std::size_t c = 0; c < theta.size(); ++c) {
    const double moved = std::abs(theta[c] - free.theta[c]), deviations = moved / std::sqrt(covariance(at(c), at(c)));
    const bool by_method = !own.empty() && std::abs(own[c] - free.theta[c]) > moved;  // is as far off without
    if (!(deviations > worst) || by_method) continue;
    worst = deviations;
    of = c;
  }
  if (of == theta.size()) return;
  tell(out, Status::doubtful,
       "The stated eigenfrequencies move " + plan.columns->name(of, plan.restriction) + " by " + digits(worst, "%.3g") +
           " of its standard deviations: the FRFs of the substructures are not exact enough there to hold a frequency. Remove "
           "[identify] frequencies, correct them, or measure the substructures with less noise.");
}

}  // namespace

double likely_cost(std::size_t equations, std::size_t lines) {
  constexpr double fewest = 4.0;
  const auto k = static_cast<double>(equations), freedom = static_cast<double>(std::max<std::size_t>(lines, 2)) - 1.0;
  const double left = std::max(fewest, freedom - k + 1.0);
  return freedom / left * k *
         boost::math::quantile(complement(boost::math::fisher_f_distribution<double>(k, left), once_in_a_thousand));
}

void judge_constraints(const Plan& plan, const FreeEstimate& free, const std::vector<double>& own,
                       const std::vector<double>& theta, Solution& out) {
  const auto cost = cost_of(plan, free, Eigen::Map<const VectorXd>(theta.data(), at(theta.size())));
  if (!cost || cost->equations == 0) return;
  const double likely = likely_cost(cost->equations, free.lines);
  if (!cost->is_above(likely)) return judge_frequencies(plan, free, own, theta, out);
  tell_cost(*cost, likely,
            free.from_knowledge ? "the noise that files and scene state"
                                : "the scatter of neighbouring lines, as files and scene do not state the noise",
            out);
}

void judge_constraints_by_residuals(const Plan& plan, const std::vector<double>& free, const std::vector<double>& theta,
                                    Solution& out) {
  constexpr double five_deviations = 25.0, least_motion = 0.01;
  if (!out.admissibility || !is_usable(out.status)) return;
  const ConstraintCost cost{out.admissibility->chi_square, out.admissibility->equations, shares_of(plan, *out.admissibility)};
  const double likely = five_deviations * static_cast<double>(cost.equations);
  if (!cost.is_above(likely)) return;
  const VectorXd largest = largest_of_kind(plan, free);
  double most = free.empty() ? 1.0 : 0.0;
  for (std::size_t c = 0; c < free.size(); ++c) most = std::max(most, std::abs(theta[c] - free[c]) / largest[at(c)]);
  if (!(most > least_motion)) return;
  tell_cost(cost, likely, "the residuals of the equations, as the noise of the FRFs is not known; noise also biases this method",
            out);
}

void judge_constraints_by_variances(const Plan& plan, double ratio, Solution& out) {
  if (!out.admissibility || !out.admissibility->from_variances) return;
  const double scale = std::max(1.0, ratio);
  ConstraintCost cost{out.admissibility->chi_square / scale, out.admissibility->equations, shares_of(plan, *out.admissibility)};
  for (CostOfOne& each : cost.each) each.chi_square /= scale;
  const double likely = chi_square_quantile(static_cast<double>(cost.equations), its_deviations);
  if (!cost.is_above(likely)) return;
  tell_cost(cost, likely,
            std::string("the variances of the FRFs") + (scale > 1.0 ? ", scaled by χ² over degrees of freedom" : ""), out);
}

}  // namespace jointid::ident
