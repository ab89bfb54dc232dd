#include "response/identify/nuisance_residuals.hpp"

#include <algorithm>
#include <utility>

#include "response/identify/corrected_models.hpp"

namespace jointid::response {
namespace {

constexpr int most_rounds = 10, most_halvings = 4;
constexpr double settled = 1e-7;              ///< largest last change of an error, in its deviations
constexpr double far = 10.0, roughly = 1e-3;  ///< cost over numbers from which the errors need not settle, and how well they do

double largest_change(const LineErrors& from, const LineErrors& to) {
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].size() > 0) largest = std::max(largest, (to[i] - from[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

}  // namespace

NuisanceResiduals::NuisanceResiduals(std::shared_ptr<const Receptance> structure, std::vector<MeasuredState> states,
                                     LawUnknowns unknowns, std::vector<int> harmonics)
    : structure_(std::move(structure)),
      states_(std::move(states)),
      unknowns_(std::move(unknowns)),
      harmonics_(std::move(harmonics)),
      layout_(ResponseResiduals(structure_, states_, unknowns_, harmonics_).models(), *structure_),
      errors_(layout_.no_errors()) {}

std::optional<NuisanceResiduals::Trial> NuisanceResiduals::tried(const LineErrors& errors, const Eigen::VectorXd& numbers,
                                                                 const std::vector<StatePrediction>& last) const {
  ResponseResiduals residuals(corrected_models(structure_, states_, layout_, errors, harmonics_), unknowns_);
  auto value = residuals.evaluate(numbers, last);
  if (!value) return std::nullopt;
  const double cost = value->linearised.residual.squaredNorm() + squared_norm(errors);
  return Trial{std::move(residuals), std::move(*value), cost};
}

bool NuisanceResiduals::move(const LineErrors& best, const Eigen::VectorXd& numbers, LineErrors& errors, Trial& trial) const {
  double share = 1.0;
  for (int i = 0; i < most_halvings; ++i, share *= 0.5) {
    LineErrors moved = errors;
    for (std::size_t line = 0; line < moved.size(); ++line) moved[line] += share * (best[line] - errors[line]);
    auto next = tried(moved, numbers, trial.value.states);
    if (!next || !(next->cost < trial.cost)) continue;
    errors = std::move(moved);
    trial = std::move(*next);
    return true;
  }
  return false;
}

std::optional<ResponseResiduals::Value> NuisanceResiduals::evaluate(const Eigen::VectorXd& numbers,
                                                                    const std::vector<StatePrediction>& last) {
  LineErrors errors = errors_;
  auto trial = tried(errors, numbers, last);
  if (!trial) return std::nullopt;
  const std::vector<Joint> joints = *unknowns_.at_numbers(numbers);
  for (int round = 0;; ++round) {
    const LineCorrelation correlation(layout_, trial->residuals.models(), trial->value.states, joints);
    const Eigen::VectorXd without = correlation.without(errors, trial->value.linearised.residual);
    const LineErrors best = correlation.best_errors(without);
    Linearised whitened = {without, trial->value.linearised.jacobian};
    correlation.whiten(whitened);
    const double rows = static_cast<double>(without.size());
    const bool is_far = trial->cost > far * rows && trial->cost - whitened.residual.squaredNorm() < roughly * trial->cost;
    const bool at_end = is_far || round == most_rounds || largest_change(errors, best) < settled;
    if (at_end || !move(best, numbers, errors, *trial)) {
      trial->value.linearised = std::move(whitened);
      break;
    }
  }
  errors_ = std::move(errors);
  return std::move(trial->value);
}

}  // namespace jointid::response
