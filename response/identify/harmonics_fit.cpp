#include "response/identify/harmonics_fit.hpp"

#include <algorithm>
#include <utility>

#include "response/identify/corrected_models.hpp"
#include "response/identify/lifted_fit.hpp"
#include "response/identify/nuisance_residuals.hpp"

namespace jointid::response {
namespace {

/// `residuals`: ResponseResiduals or NuisanceResiduals.
template <class R>
FitOfHarmonics fit_residuals(R& residuals, const Eigen::VectorXd& start, std::vector<StatePrediction> from,
                             const GaussNewtonOptions& options) {
  FitOfHarmonics fit;
  const auto linearise = [&](const Eigen::VectorXd& numbers) -> std::optional<Linearised> {
    auto value = residuals.evaluate(numbers, from);
    if (!value) return std::nullopt;
    from = std::move(value->states);
    return std::move(value->linearised);
  };
  fit.result = gauss_newton(linearise, start, options);
  if (!fit.result.defined) return fit;
  auto last = residuals.evaluate(fit.result.unknowns, from);
  if (last) fit.states = std::move(last->states);
  return fit;
}

double cost(const FitOfHarmonics& fit) { return fit.result.at.residual.squaredNorm(); }

}  // namespace

bool knows_errors(const Receptance& structure, const std::vector<MeasuredState>& states) {
  return std::ranges::any_of(states, [&](const MeasuredState& state) {
    return std::ranges::any_of(state.harmonics, [&](int n) { return !structure.errors(n * state.omega).empty(); });
  });
}

HarmonicsFits::HarmonicsFits(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                             const LawUnknowns& unknowns, bool nuisance, const GaussNewtonOptions& options)
    : structure_(std::move(structure)), states_(states), unknowns_(unknowns), nuisance_(nuisance), options_(options) {}

FitOfHarmonics HarmonicsFits::plain(const std::vector<int>& harmonics, const Eigen::VectorXd& start,
                                    std::vector<StatePrediction> from) const {
  ResponseResiduals residuals(structure_, states_, unknowns_, harmonics);
  return fit_residuals(residuals, start, std::move(from), options_);
}

FitOfHarmonics HarmonicsFits::with_nuisance(const std::vector<int>& harmonics, const FitOfHarmonics& before) const {
  NuisanceResiduals residuals(structure_, states_, unknowns_, harmonics);
  if (before.layout) residuals.begin_with(carried(*before.layout, before.errors, residuals.layout()));
  FitOfHarmonics fit = fit_residuals(residuals, before.result.unknowns, before.states, options_);
  fit.layout = residuals.layout();
  fit.errors = residuals.errors();
  return fit;
}

FitOfHarmonics HarmonicsFits::next(const std::vector<int>& harmonics, const FitOfHarmonics& before) const {
  return nuisance_ ? with_nuisance(harmonics, before) : plain(harmonics, before.result.unknowns, before.states);
}

FitOfHarmonics HarmonicsFits::first(const std::vector<int>& harmonics) const {
  FitOfHarmonics fit;
  auto lifted = fit_lifted(structure_, states_, unknowns_, harmonics);
  if (lifted) {
    FitOfHarmonics from;
    from.result.unknowns = lifted->numbers;
    from.states = std::move(lifted->states);
    if (nuisance_) {
      from.layout = std::move(lifted->layout);
      from.errors = std::move(lifted->errors);
    }
    fit = next(harmonics, from);
    if (fit.result.converged) return fit;
  }
  FitOfHarmonics other = plain(harmonics, unknowns_.start(), {});
  const int steps = other.result.steps;
  if (nuisance_ && other.result.defined) other = with_nuisance(harmonics, other);
  other.result.steps += steps;
  const auto rank = [](const FitOfHarmonics& each) { return std::pair(!each.result.converged, cost(each)); };
  return !fit.result.defined || (other.result.defined && rank(other) < rank(fit)) ? other : fit;
}

}  // namespace jointid::response
