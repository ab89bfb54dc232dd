#include "response/identify/harmonics_fit.hpp"

#include <algorithm>
#include <utility>

#include "base/statistics.hpp"
#include "response/identify/corrected_models.hpp"
#include "response/identify/nuisance_residuals.hpp"

namespace jointid::response {
namespace {

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
    return state.knows_force_errors() ||
           std::ranges::any_of(state.harmonics, [&](int n) { return !structure.errors(n * state.omega).empty(); });
  });
}

HarmonicsFits::HarmonicsFits(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                             const LawUnknowns& unknowns, const FitWays& ways)
    : structure_(std::move(structure)), states_(states), unknowns_(unknowns), ways_(ways) {}

minimise::GaussNewtonOptions HarmonicsFits::steps(double enough) const {
  minimise::GaussNewtonOptions options = ways_.steps;
  options.enough = std::max(options.enough, enough);
  return options;
}

FitOfHarmonics HarmonicsFits::at(const std::vector<int>& harmonics, const Eigen::VectorXd& numbers) const {
  FitOfHarmonics fit;
  std::optional<minimise::Linearised> found;
  if (ways_.nuisance) {
    NuisanceResiduals residuals(structure_, states_, unknowns_, harmonics, ways_.work);
    found = residuals.evaluate(numbers);
    fit.states = residuals.states();
  } else {
    const ResponseResiduals residuals(structure_, states_, unknowns_, harmonics, ways_.work);
    auto value = residuals.evaluate(numbers);
    if (value) {
      found = std::move(value->linearised);
      fit.states = std::move(value->states);
    }
  }
  if (found) fit.result = {.defined = true, .converged = true, .steps = 0, .unknowns = numbers, .at = std::move(*found)};
  return fit;
}

FitOfHarmonics HarmonicsFits::plain(const std::vector<int>& harmonics, const Eigen::VectorXd& start,
                                    std::vector<StatePrediction> from, double enough) const {
  const ResponseResiduals residuals(structure_, states_, unknowns_, harmonics, ways_.work);
  FitOfHarmonics fit;
  const auto linearise = [&](const Eigen::VectorXd& numbers) -> std::optional<minimise::Linearised> {
    auto value = residuals.evaluate(numbers, from);
    if (!value) return std::nullopt;
    from = std::move(value->states);
    return std::move(value->linearised);
  };
  fit.result = minimise::gauss_newton(linearise, start, steps(enough));
  if (!fit.result.defined) return fit;
  auto last = residuals.evaluate(fit.result.unknowns, from);
  if (last) fit.states = std::move(last->states);
  return fit;
}

FitOfHarmonics HarmonicsFits::with_nuisance(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const {
  NuisanceResiduals residuals(structure_, states_, unknowns_, harmonics, ways_.work);
  if (before.layout) residuals.begin_with(carried(*before.layout, before.errors, residuals.layout()));
  FitOfHarmonics fit;
  fit.result = residuals.fit(before.result.unknowns, before.states, steps(enough));
  fit.layout = residuals.layout();
  fit.errors = residuals.errors();
  fit.states = residuals.states();
  return fit;
}

FitOfHarmonics HarmonicsFits::from(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const {
  return ways_.nuisance ? with_nuisance(harmonics, before, enough)
                        : plain(harmonics, before.result.unknowns, before.states, enough);
}

FitOfHarmonics HarmonicsFits::from_lifted(const std::vector<int>& harmonics, std::optional<LiftedFit> lifted, double enough) const {
  if (!lifted) return {};
  FitOfHarmonics start;
  start.result.unknowns = lifted->numbers;
  start.states = std::move(lifted->states);
  start.layout = std::move(lifted->layout);
  start.errors = std::move(lifted->errors);
  return from(harmonics, start, enough);
}

FitOfHarmonics HarmonicsFits::next(const std::vector<int>& harmonics, const FitOfHarmonics& before, double enough) const {
  FitOfHarmonics fit = from(harmonics, before, enough);
  if (fit.result.converged || !ways_.nuisance) return fit;
  const LiftedFit start = {before.result.unknowns, *before.layout, before.errors, before.states, 0.0, 0};
  return better(std::move(fit),
                from_lifted(harmonics, fit_lifted(structure_, states_, unknowns_, harmonics, start, ways_.work), enough));
}

FitOfHarmonics HarmonicsFits::first(const std::vector<int>& harmonics, double enough) const {
  auto lifted = fit_lifted(structure_, states_, unknowns_, harmonics, ways_.work);
  // What misses the data a little meets the law too loosely yet: balance would begin far from its states.
  constexpr double hopeless = 4.0;
  const auto numbers = static_cast<double>(measured_numbers(states_));
  if (lifted && lifted->chi_square > chi_square_quantile(numbers, 4.0) && lifted->chi_square < hopeless * numbers) {
    auto closer = fit_lifted(structure_, states_, unknowns_, harmonics, *lifted, ways_.work);
    if (closer) lifted = std::move(closer);
  }
  FitOfHarmonics fit = from_lifted(harmonics, lifted, enough);
  if (fit.result.converged) return fit;
  if (lifted) {
    fit = better(std::move(fit),
                 from_lifted(harmonics, fit_lifted(structure_, states_, unknowns_, harmonics, *lifted, ways_.work), enough));
    if (fit.result.converged) return fit;
  }
  FitOfHarmonics other = plain(harmonics, unknowns_.start(), {}, enough);
  const int steps = other.result.steps;
  if (ways_.nuisance && other.result.defined) other = with_nuisance(harmonics, other, enough);
  other.result.steps += steps;
  return better(std::move(fit), std::move(other));
}

}  // namespace jointid::response
