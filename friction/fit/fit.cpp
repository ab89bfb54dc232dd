#include "friction/fit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/control.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "friction/fit/fit_problem.hpp"
#include "friction/fit/fit_statistics.hpp"
#include "friction/fit/tied_limit.hpp"
#include "friction/law/laws.hpp"

namespace jointid::friction {
namespace {

bool uses_ceres(Minimiser minimiser) {
  if (minimiser == Minimiser::ceres && !minimise::has_ceres()) refuse("this build lacks Ceres; use pattern search");
  return minimiser != Minimiser::pattern && minimise::has_ceres();
}

/// Whether dT/du falls at once somewhere, so that residuals have kinks in the parameters where they meet samples.
bool is_sharp(const Element& element) {
  const auto kinks = element.kinks();
  const double first = element.response(0.0).tangent;
  return std::ranges::any_of(kinks, [&](double u) {
    return element.response(u * (1.0 - 1e-9)).tangent - element.response(u).tangent > 0.01 * first;
  });
}

double objective(const minimise::LeastSquares& problem, const minimise::Minimum& minimum) { return problem.objective(minimum.q); }

/// Kinks can stop Levenberg–Marquardt short of the minimum: a coarse pattern search looks beyond them.
minimise::Minimum polished(const FitProblem& problem, minimise::Minimum minimum) {
  constexpr int rounds = 4;
  const auto f = [&](std::span<const double> q) { return problem.objective(q); };
  for (int round = 0; round < rounds; ++round) {
    const minimise::Minimum looked = minimise::pattern_search(f, minimum.q, {.step = 0.02, .tolerance = 1e-4, .most_evaluations = 400});
    if (!(objective(problem, looked) < objective(problem, minimum) * (1.0 - 1e-7))) break;
    const std::size_t before = minimum.iterations;
    minimum = minimise::ceres_minimum(problem, looked.q);
    minimum.iterations += before;
  }
  return minimum;
}

/// A few steps from every start, then all the way from where the best of them leads.
minimise::Minimum by_ceres(const FitProblem& problem, const std::vector<std::vector<double>>& starts) {
  minimise::Minimum best{starts.front(), 0, false};
  std::size_t iterations = 0;
  for (std::size_t i = 0; i < starts.size() && starts.size() > 1; ++i) {
    minimise::Minimum tried = minimise::ceres_minimum(problem, starts[i], {.tolerance = 1e-3, .most_iterations = 12});
    iterations += tried.iterations;
    if (i == 0 || objective(problem, tried) < objective(problem, best)) best = std::move(tried);
  }
  best = minimise::ceres_minimum(problem, best.q);
  best.iterations += iterations;
  const auto state = problem.state(0, best.q, false);
  return state && is_sharp(*state->element) ? polished(problem, std::move(best)) : best;
}

/// Pattern search from every start; the best.
minimise::Minimum by_pattern(const FitProblem& problem, const std::vector<std::vector<double>>& starts) {
  const auto f = [&](std::span<const double> q) { return problem.objective(q); };
  minimise::Minimum best;
  for (const std::vector<double>& start : starts) {
    minimise::Minimum found = minimise::pattern_search(f, start);
    if (best.q.empty() || objective(problem, found) < objective(problem, best)) best = std::move(found);
  }
  return best;
}

/// Minimisers of other libraries make another exception of what stops them.
minimise::Minimum minimise(const FitProblem& problem, const FitOptions& options) try {
  const auto& starts = problem.starts();
  const minimise::Minimum found = uses_ceres(options.minimiser) ? by_ceres(problem, starts) : by_pattern(problem, starts);
  stop_if(options.interrupted);
  return found;
} catch (const std::exception&) {
  stop_if(options.interrupted);
  throw;
}

double weighted_squares(const Curve& curve, const std::vector<double>& values, const std::vector<double>& weights) {
  double sum = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += std::pow(weights[i] * (values[i] - curve.measured(i)), 2);
  return sum;
}

/// ΔE (2.58b), or (7.20), docs/formulas.md §10f.
double objective_of(const Curve& curve, const std::vector<double>& predicted) {
  return weighted_squares(curve, predicted, row_weights(curve, Weighting::largest));
}

double aic_of(double squares, std::size_t rows, std::size_t unknowns) {
  const double n = static_cast<double>(rows);
  return n * std::log(squares / n) + 2.0 * static_cast<double>(unknowns + 1);
}

/// The sum of squares of the linear spring that fits best.
double spring_squares(const Curve& curve, const std::vector<double>& weights) {
  std::vector<double> values = predicted(*make_element("spring", std::array{1.0}), curve);
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    xx += std::pow(weights[i] * values[i], 2);
    xy += weights[i] * weights[i] * values[i] * curve.measured(i);
  }
  for (double& value : values) value *= xy / xx;
  return weighted_squares(curve, values, weights);
}

/// Whether the element explains the curve better, by AIC, than a spring that never slips.
bool shows_slip(const Curve& curve, const Element& element, const std::vector<double>& values, const FitOptions& options) {
  const std::vector<double> weights = row_weights(curve, options.weighting);
  const std::size_t unknowns = element.parameters().size() - (options.limit ? 1 : 0);
  return aic_of(weighted_squares(curve, values, weights), curve.rows(), unknowns) <
         aic_of(spring_squares(curve, weights), curve.rows(), 1);
}

std::string stiffness_unit(const Curve& curve) { return curve.force_unit + "/" + curve.displacement_unit; }

class Description {
 public:
  Description(const FitStatistics& statistics, const FitOptions& options) : statistics_(statistics), options_(options) {}

  CurveFit of(const Curve& curve, CurveState state) const {
    CurveFit out;
    out.curve = curve;
    out.predicted = predicted(*state.element, curve);
    out.objective = objective_of(curve, out.predicted);
    const double largest = curve.largest_displacement();
    const double first = state.element->response(0.0).tangent;
    out.slipped_share = 1.0 - state.element->response(largest).tangent / first;
    const std::vector<Parameter> parameters = state.element->parameters();
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      out.parameters.push_back(statistics_.describe(parameters[i], state.by_unknown.row(at(i))));
    }
    out.stiffness = derived("initial stiffness", stiffness_unit(curve), first, stiffness_derivative(*state.element, largest), state);
    out.limit = limit(curve, state, out.slipped_share);
    out.shows_slip = shows_slip(curve, *state.element, out.predicted, options_);
    if (!out.shows_slip && out.limit.knowledge != Knowledge::preset) out.limit.knowledge = Knowledge::undetermined;
    if (curve.normal_load && std::isfinite(out.limit.value)) out.friction_coefficient = coefficient(out.limit, *curve.normal_load);
    out.element = std::move(state.element);
    return out;
  }

 private:
  FittedValue derived(const char* name, const std::string& unit, double value, const std::vector<double>& by,
                      const CurveState& state) const {
    const Eigen::Map<const Eigen::RowVectorXd> by_parameter(by.data(), at(by.size()));
    return statistics_.describe({name, unit, value, 0.0, infinity, true}, by_parameter * state.by_unknown);
  }

  FittedValue limit(const Curve& curve, const CurveState& state, double slipped) const {
    const double value = state.element->limit();
    if (!std::isfinite(value)) return {"friction limit", curve.force_unit, value, {}, {}, Knowledge::undetermined};
    if (options_.limit) return {"friction limit", curve.force_unit, value, {}, {}, Knowledge::preset};
    FittedValue out = derived("friction limit", curve.force_unit, value, limit_derivative(*state.element), state);
    if (out.knowledge == Knowledge::determined && slipped < macroslip) out.knowledge = Knowledge::extrapolated;
    return out;
  }

  static FittedValue coefficient(FittedValue limit, double load) {
    limit.name = "mu";
    limit.unit = "1";
    limit.value /= load;
    if (limit.std_error) *limit.std_error /= load;
    if (limit.ci95) limit.ci95 = {(*limit.ci95)[0] / load, (*limit.ci95)[1] / load};
    return limit;
  }

  const FitStatistics& statistics_;
  const FitOptions& options_;
};

bool is_undetermined(const FittedValue& value) { return value.knowledge == Knowledge::undetermined; }

/// "a of 50 kg" when there are several curves.
std::string of_curve(const std::string& name, const CurveFit& curve, bool alone) {
  return alone ? name : name + " of " + curve.curve.name;
}

std::vector<std::string> findings_of(const CurveFit& found, bool alone) {
  std::vector<std::string> out;
  for (const FittedValue& value : found.parameters) {
    if (is_undetermined(value)) out.push_back(of_curve(value.name, found, alone) + " is not determined by the data");
  }
  const std::string limit = of_curve("friction limit", found, alone);
  if (!found.shows_slip && std::isfinite(found.limit.value)) {
    out.push_back(of_curve("slip", found, alone) + " is not seen: a linear spring explains the data as well");
  }
  if (is_undetermined(found.limit) && std::isfinite(found.limit.value)) {
    out.push_back(limit + " is not determined: the curve does not come near macroslip; load further or preset the limit");
  }
  if (found.limit.knowledge == Knowledge::extrapolated) {
    const int share = static_cast<int>(std::floor(100.0 * found.slipped_share));
    out.push_back(limit + " is extrapolated by the law: " + std::to_string(share) +
                  " % of the stiffness area slip at the largest displacement, macroslip is not reached");
  }
  return out;
}

/// Unknowns of which only a combination is well known, where some parameter is not.
std::vector<std::string> pairs_that_move_together(const Fit& fit) {
  constexpr double close = 0.99;
  std::vector<std::string> out;
  const auto lacks = [](const CurveFit& curve) { return std::ranges::any_of(curve.parameters, is_undetermined); };
  if (std::ranges::none_of(fit.curves, lacks)) return out;
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(fit.correlation[i][j]) > close)
        out.push_back(fit.names[j] + " and " + fit.names[i] + " move together: only a combination of them is well known");
    }
  }
  return out;
}

/// Lag-one correlation of the weighted residuals, curve by curve.
double neighbour_correlation(const Fit& fit, Weighting weighting) {
  double products = 0.0, squares = 0.0;
  for (const CurveFit& each : fit.curves) {
    const std::vector<double> weights = row_weights(each.curve, weighting);
    double before = 0.0;
    for (std::size_t i = 0; i < each.predicted.size(); ++i) {
      const double r = weights[i] * (each.predicted[i] - each.curve.measured(i));
      products += i > 0 ? r * before : 0.0;
      squares += r * r;
      before = r;
    }
  }
  return squares > 0.0 ? products / squares : 0.0;
}

/// What correlated residuals do to standard errors: they belong to about rows·(1 − ρ)/(1 + ρ) independent ones.
std::string correlated_residuals(double rho) {
  const double factor = std::sqrt((1.0 + rho) / std::max(1.0 - rho, 1e-6));
  return "residuals of neighbouring samples are correlated (" + std::to_string(rho).substr(0, 5) +
         "): the law misses what is systematic, standard errors are too small by a factor of about " +
         std::to_string(static_cast<int>(std::lround(factor)));
}

void judge(bool converged, Fit& fit) {
  if (!converged) {
    fit.status = Status::not_converged;
    fit.message = "the fit of " + fit.law + " did not converge";
  }
  for (const CurveFit& curve : fit.curves) {
    for (std::string& finding : findings_of(curve, fit.curves.size() == 1)) fit.findings.push_back(std::move(finding));
  }
  constexpr double much = 0.6;
  if (fit.rows > 20 && fit.neighbour_correlation > much) fit.findings.push_back(correlated_residuals(fit.neighbour_correlation));
  for (std::string& finding : pairs_that_move_together(fit)) fit.findings.push_back(std::move(finding));
}

void fill(std::span<const Curve> curves, const FitProblem& problem, const FitOptions& options, const minimise::Minimum& minimum,
          const FitStatistics& statistics, Fit& fit) {
  const Description describe(statistics, options);
  for (std::size_t c = 0; c < curves.size(); ++c) {
    fit.curves.push_back(describe.of(curves[c], *problem.state(c, minimum.q, true)));
    fit.objective += fit.curves.back().objective;
  }
  fit.neighbour_correlation = neighbour_correlation(fit, options.weighting);
  fit.weighted_sum = statistics.sum_of_squares();
  fit.residual_std = statistics.residual_std();
  fit.aic = aic_of(fit.weighted_sum, fit.rows, fit.unknowns);
  fit.correlation.assign(fit.unknowns, std::vector<double>(fit.unknowns));
  for (std::size_t i = 0; i < fit.unknowns; ++i) {
    for (std::size_t j = 0; j < fit.unknowns; ++j) fit.correlation[i][j] = statistics.correlation(i, j);
  }
}

}  // namespace

Fit fit(std::span<const Curve> curves, const Family& family, const FitOptions& options) {
  const FitProblem problem(curves, family, options);
  Fit out;
  out.law = family.name;
  out.title = family.title;
  out.names = problem.names();
  out.rows = problem.residuals();
  out.unknowns = problem.unknowns();
  if (out.rows <= out.unknowns) {
    out.status = Status::too_few_points;
    out.message = std::to_string(out.rows) + " measured numbers cannot determine " + std::to_string(out.unknowns) + " unknowns";
    return out;
  }
  const minimise::Minimum minimum = minimise(problem, options);
  out.minimiser = uses_ceres(options.minimiser) ? "ceres" : "pattern";
  out.iterations = minimum.iterations;
  const FitStatistics statistics(problem, minimum.q);
  fill(curves, problem, options, minimum, statistics, out);
  judge(minimum.converged, out);
  return out;
}

std::vector<Fit> compare(std::span<const Curve> curves, std::span<const Family> families, const FitOptions& options) {
  std::vector<Fit> fits;
  for (const Family& family : families) fits.push_back(fit(curves, family, options));
  const auto key = [](const Fit& each) { return std::pair(each.status != Status::ok, each.aic); };
  std::ranges::stable_sort(fits, {}, key);
  return fits;
}

}  // namespace jointid::friction
