#include "response/identify/nuisance_residuals.hpp"

#include <algorithm>
#include <utility>

#include "response/identify/corrected_models.hpp"

namespace jointid::response {
namespace {

constexpr int most_rounds = 30, most_halvings = 4;
constexpr double settled = 1e-7;              ///< largest last change of an error, in its deviations
constexpr double most_step_damping = 1e6;
/// Deviations by which a step that lowers the cost at no length would move the numbers, at most. A loop of the motion that is
/// about to appear or to vanish bends the cost sharply; one state there holds all others up.
constexpr double most_at_kink = 1.0;
constexpr double step_shares[] = {1.0, 0.3};       ///< of a step that are tried before more damping

double largest_change(const LineErrors& from, const LineErrors& to) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].size() > 0) largest = std::max(largest, (to[i] - from[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

NuisanceResiduals::NuisanceResiduals(std::shared_ptr<const Receptance> structure, std::vector<MeasuredState> states,
                                     LawUnknowns unknowns, std::vector<int> harmonics, FitWork work)
    : structure_(std::move(structure)),
      states_(std::move(states)),
      unknowns_(std::move(unknowns)),
      harmonics_(std::move(harmonics)),
      work_(std::move(work)),
      layout_(ResponseResiduals(structure_, states_, unknowns_, harmonics_).models(), *structure_),
      errors_(layout_.no_errors()) {}

std::optional<NuisanceResiduals::Trial> NuisanceResiduals::tried(LineErrors errors, const Eigen::VectorXd& numbers,
                                                                 const std::vector<StatePrediction>& last) const {
  ResponseResiduals residuals(corrected_models(structure_, states_, layout_, errors, harmonics_), unknowns_, work_);
  auto value = residuals.evaluate(numbers, last);
  if (!value) return std::nullopt;
  const double cost = value->linearised.residual.squaredNorm() + squared_norm(errors);
  return Trial{numbers, std::move(errors), std::move(residuals), std::move(*value), cost};
}

void NuisanceResiduals::linearise(const Trial& trial, FirstOrder& at) const {
  at.correlation.set(trial.residuals.models(), trial.value.states, joint_forces(*unknowns_.at_numbers(trial.numbers)));
  at.without = at.correlation.without(trial.errors, trial.value.linearised.residual);
  at.reduced = at.correlation.whitened(at.without, trial.value.linearised.jacobian);
}

LineErrors NuisanceResiduals::best_errors(const FirstOrder& at, const Trial& trial, const Eigen::VectorXd& step) const {
  return at.correlation.best_errors(at.without + trial.value.linearised.jacobian * step);
}

std::optional<NuisanceResiduals::Trial> NuisanceResiduals::moved(const Trial& trial, const Eigen::VectorXd& step,
                                                                 const LineErrors& best, double share) const {
  LineErrors errors = trial.errors;
  for (std::size_t line = 0; line < errors.size(); ++line) errors[line] += share * (best[line] - trial.errors[line]);
  return tried(std::move(errors), trial.numbers + share * step, trial.value.states);
}

bool NuisanceResiduals::settle(const LineErrors& best, Trial& trial) const {
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(trial.numbers.size());
  double share = 1.0;
  for (int i = 0; i < most_halvings; ++i, share *= 0.5) {
    auto next = moved(trial, none, best, share);
    if (!next || !(next->cost < trial.cost)) continue;
    trial = std::move(*next);
    return true;
  }
  return false;
}

void NuisanceResiduals::keep(Trial&& trial) {
  errors_ = std::move(trial.errors);
  states_found_ = std::move(trial.value.states);
}

std::optional<minimise::Linearised> NuisanceResiduals::evaluate(const Eigen::VectorXd& numbers,
                                                                const std::vector<StatePrediction>& last) {
  auto trial = tried(errors_, numbers, last);
  if (!trial) return std::nullopt;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(numbers.size());
  FirstOrder at = nothing();
  for (int round = 0;; ++round) {
    linearise(*trial, at);
    const LineErrors best = best_errors(at, *trial, none);
    if (round < most_rounds && largest_change(trial->errors, best) >= settled && settle(best, *trial)) continue;
    keep(std::move(*trial));
    return std::move(at.reduced);
  }
}

bool NuisanceResiduals::descend(const FirstOrder& at, Trial& trial, minimise::Damping& damping) const {
  return damping.search([&](double value) {
    const Eigen::VectorXd step = minimise::damped_step(at.reduced, value);
    const LineErrors best = best_errors(at, trial, step);
    for (const double share : step_shares) {
      auto next = moved(trial, step, best, share);
      if (!next || !(next->cost < trial.cost)) continue;
      trial = std::move(*next);
      if (share == 1.0) damping.less();
      return true;
    }
    return false;
  });
}

minimise::GaussNewtonResult NuisanceResiduals::fit(const Eigen::VectorXd& start, const std::vector<StatePrediction>& last,
                                                   const minimise::GaussNewtonOptions& options) {
  minimise::GaussNewtonResult result;
  result.unknowns = start;
  auto trial = tried(errors_, start, last);
  if (!trial) return result;
  result.defined = true;
  minimise::GaussNewtonEnd end(options);
  minimise::Damping damping({.most = most_step_damping});
  FirstOrder at = nothing();
  linearise(*trial, at);
  for (; result.steps < options.most_steps; ++result.steps) {
    const Eigen::VectorXd full = minimise::damped_step(at.reduced, 0.0);
    const Eigen::VectorXd changed = at.reduced.jacobian * full;
    const double least = (at.reduced.residual + changed).squaredNorm(), movement = changed.norm();
    const auto what = end.judge(full, movement, trial->cost, trial->cost - least);
    if (what == minimise::GaussNewtonEnd::What::here) {
      result.converged = true;
      break;
    }
    if (what == minimise::GaussNewtonEnd::What::descend) {
      if (!descend(at, *trial, damping)) {
        result.converged = end.at_rounding() || movement < most_at_kink;
        if (!end.at_rounding()) result.kink = movement;
        break;
      }
    } else {
      auto next = moved(*trial, full, best_errors(at, *trial, full), 1.0);
      if (!next) break;
      if (end.shrinks()) *trial = std::move(*next);
      result.converged = end.is_last();
    }
    linearise(*trial, at);
    if (result.converged) break;
  }
  result.unknowns = trial->numbers;
  result.at = std::move(at.reduced);
  keep(std::move(*trial));
  return result;
}

}  // namespace jointid::response
