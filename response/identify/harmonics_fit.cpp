#include "response/identify/harmonics_fit.hpp"

#include <algorithm>
#include <utility>

#include "response/identify/corrected_models.hpp"
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

template <class R>
FitOfHarmonics value_at(R& residuals, const Eigen::VectorXd& numbers) {
  FitOfHarmonics fit;
  auto value = residuals.evaluate(numbers);
  if (!value) return fit;
  fit.result = {.defined = true, .converged = true, .steps = 0, .unknowns = numbers, .at = std::move(value->linearised)};
  fit.states = std::move(value->states);
  return fit;
}

/// The one that converged, or else that with the smaller sum.
FitOfHarmonics better(FitOfHarmonics a, FitOfHarmonics b) {
  if (!a.result.defined || !b.result.defined) return a.result.defined ? a : b;
  const auto rank = [](const FitOfHarmonics& fit) {
    return std::pair(!fit.result.converged, fit.result.at.residual.squaredNorm());
  };
  return rank(b) < rank(a) ? b : a;
}

}  // namespace

bool knows_errors(const Receptance& structure, const std::vector<MeasuredState>& states) {
  return std::ranges::any_of(states, [&](const MeasuredState& state) {
    return std::ranges::any_of(state.harmonics, [&](int n) { return !structure.errors(n * state.omega).empty(); });
  });
}

HarmonicsFits::HarmonicsFits(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                             const LawUnknowns& unknowns, bool nuisance, const GaussNewtonOptions& options)
    : structure_(std::move(structure)), states_(states), unknowns_(unknowns), nuisance_(nuisance), options_(options) {}

FitOfHarmonics HarmonicsFits::at(const std::vector<int>& harmonics, const Eigen::VectorXd& numbers) const {
  if (nuisance_) {
    NuisanceResiduals residuals(structure_, states_, unknowns_, harmonics);
    return value_at(residuals, numbers);
  }
  ResponseResiduals residuals(structure_, states_, unknowns_, harmonics);
  return value_at(residuals, numbers);
}

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

FitOfHarmonics HarmonicsFits::from(const std::vector<int>& harmonics, const FitOfHarmonics& before) const {
  return nuisance_ ? with_nuisance(harmonics, before) : plain(harmonics, before.result.unknowns, before.states);
}

FitOfHarmonics HarmonicsFits::from_lifted(const std::vector<int>& harmonics, std::optional<LiftedFit> lifted) const {
  if (!lifted) return {};
  FitOfHarmonics start;
  start.result.unknowns = lifted->numbers;
  start.states = std::move(lifted->states);
  start.layout = std::move(lifted->layout);
  start.errors = std::move(lifted->errors);
  return from(harmonics, start);
}

FitOfHarmonics HarmonicsFits::next(const std::vector<int>& harmonics, const FitOfHarmonics& before) const {
  if (!nuisance_) return from(harmonics, before);
  const LiftedFit start = {before.result.unknowns, *before.layout, before.errors, before.states, 0.0, 0};
  FitOfHarmonics fit = from_lifted(harmonics, fit_lifted(structure_, states_, unknowns_, harmonics, start));
  return fit.result.converged ? fit : better(std::move(fit), from(harmonics, before));
}

FitOfHarmonics HarmonicsFits::first(const std::vector<int>& harmonics) const {
  FitOfHarmonics fit = from_lifted(harmonics, fit_lifted(structure_, states_, unknowns_, harmonics));
  if (fit.result.converged) return fit;
  FitOfHarmonics other = plain(harmonics, unknowns_.start(), {});
  const int steps = other.result.steps;
  if (nuisance_ && other.result.defined) other = with_nuisance(harmonics, other);
  other.result.steps += steps;
  return better(std::move(fit), std::move(other));
}

}  // namespace jointid::response
