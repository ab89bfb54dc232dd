#include "ident/newton/newton.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "base/random.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "ident/admissible/eigenfrequencies.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/newton/constrained_iteration.hpp"
#include "ident/newton/iteration.hpp"
#include "ident/newton/loose_by_frequencies.hpp"
#include "ident/newton/newton_plan.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/joint_guess.hpp"
#include "ident/plan/prediction.hpp"
#include "ident/result/minima.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/start_points.hpp"

namespace jointid::ident {
namespace {

using Point = std::vector<double>;

/// Seven lines in ten, other ones in every iteration: each choice has local minima of its own (docs/formulas.md §7).
std::function<bool()> draws_of(std::size_t start) {
  return [start, drawn = std::uint64_t{0}]() mutable { return uniform_numbers({.seed = 2, .trial = start}, drawn++)[0] < 0.7; };
}

/// Hooke and Jeeves, without derivatives. It compares misfits: weights by sensitivity would favour points whose resonances lie on the
/// lines. Every point better than those before is watched like the beginning of an iteration.
NewtonFit by_pattern(ResponseProblem& problem, const Point& start, const NewtonOptions& options) {
  const RoundCoordinates round(problem, start);
  double best = std::numeric_limits<double>::infinity();
  const minimise::Objective objective = [&](std::span<const double> x) {
    const Point q = round.point(x);
    const double misfit = problem.misfit(q);
    if (options.watch && misfit < best) options.watch(q);
    best = std::min(best, misfit);
    return misfit;
  };
  const double size = round.size();
  const minimise::Minimum found = minimise::pattern_search(
      objective, Point(start.size(), 0.0), {.step = 0.1 * size, .tolerance = 1e-10 * size, .most_evaluations = 20000});
  NewtonFit fit{.q = round.point(found.q), .iterations = found.iterations, .converged = found.converged};
  fit.diverged = runs_away(fit.q);
  return fit;
}

/// One run of the plan's solver.
NewtonFit run(Solver solver, ResponseProblem& problem, const Point& start, const NewtonOptions& options) {
  if (solver == Solver::newton) return divided_newton(problem, start, options);
  if (solver == Solver::ceres) {
    const auto few = [&](std::span<const double> q) {
      return minimise::ceres_minimum(problem, q, {.tolerance = 1e-14, .most_iterations = 4});
    };
    return in_rounds(problem, start, few, options);
  }
  if (solver == Solver::ipopt) {
    const auto few = [&](std::span<const double> q) {
      return minimise::ipopt_minimum(problem, q, {.tolerance = 1e-12, .most_iterations = 4, .lower = {}, .upper = {}});
    };
    return in_rounds(problem, start, few, options);
  }
  if (solver == Solver::pattern) return by_pattern(problem, start, options);
  return damped_newton(problem, start, options);
}

bool same(const FoundMinimum& a, const FoundMinimum& b) {
  double distance = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    distance = std::max(distance, std::abs(a.values[i] - b.values[i]));
    size = std::max(size, std::abs(a.values[i]));
  }
  return distance <= 1e-3 * size;
}

/// The best of one run or several, by how well it predicts the assembly.
class Search {
 public:
  /// `begun`: what Control::so_far is given besides estimates.
  Search(const Plan& plan, ResponseProblem& problem, const Solution& begun, const Control& control)
      : plan_(plan), problem_(problem), begun_(begun), control_(control) {}

  void from(const Point& start, std::size_t number) {
    NewtonOptions options;
    options.watch = [this](const Point& q) { watch(q); };
    is_constrained_ = !plan_.admissible;
    if (number > 0) options.draw = draws_of(number);
    NewtonFit fit = run_or_stop(start, options);
    stop_if(control_.interrupted);
    if (plan_.admissible) {
      options.draw = {};
      is_constrained_ = true;
      fit = constrained_newton(problem_, *plan_.admissible, fit.diverged ? start : fit.q, options, fit.iterations);
    }
    fit.converged = fit.converged && !fit.diverged;
    iterations_ += fit.iterations;
    const double misfit = problem_.misfit(fit.q);
    if (!std::isfinite(misfit)) return;
    if (fit.converged) minima_.add({misfit, 1, fit.q}, same);
    const bool returns = best_.diverged && !fit.diverged;  // one that ran away says nothing
    if (!best_.q.empty() && !returns && (misfit >= misfit_ || fit.diverged)) return;
    best_ = std::move(fit);
    misfit_ = misfit;
  }

  const NewtonFit& best() const { return best_; }
  double misfit() const { return misfit_; }
  std::size_t iterations() const { return iterations_; }
  const MinimumList& minima() const { return minima_; }

 private:
  void watch(const Point& q) {
    ++steps_;
    if (control_.progress) control_.progress(("step " + std::to_string(steps_)).c_str(), 0, 0);
    if (control_.so_far && is_constrained_) tell(q);
    stop_if(control_.interrupted);
  }

  void tell(const Point& q) {
    const double misfit = problem_.misfit(q);
    if (!(misfit < told_)) return;
    told_ = misfit;
    Solution best = begun_;
    best.status = Status::not_converged;
    minimise::LinearSolution linear;
    linear.y = problem_.theta(q);
    linear.rank = linear.y.size();
    interpret(plan_, linear, best);
    best.fit.iterations = steps_;
    best.fit.objective = misfit;
    control_.so_far(best);
  }

  /// Minimisers of other libraries make another exception of what stops them.
  NewtonFit run_or_stop(const Point& start, const NewtonOptions& options) {
    try {
      return run(plan_.solver, problem_, start, options);
    } catch (const Interrupted&) {
      throw;
    } catch (const std::exception&) {
      stop_if(control_.interrupted);
      throw;
    }
  }

  const Plan& plan_;
  ResponseProblem& problem_;
  const Solution& begun_;
  const Control& control_;
  double told_ = std::numeric_limits<double>::infinity();
  std::size_t steps_ = 0;
  bool is_constrained_ = true;  ///< the steps watched keep the constraints of the scene
  NewtonFit best_;
  double misfit_ = std::numeric_limits<double>::infinity();
  std::size_t iterations_ = 0;
  MinimumList minima_;
};

/// From the start that fits best by its size, then from others until one settles; as many as the scene asks for.
void search(const Plan& plan, const NewtonPlan& own, const ResponseProblem& problem, const Control& control, Search& found,
            RunTime& time) {
  const Clock::time_point begun = Clock::now();
  const std::size_t wanted = plan.scene.identify.starts;
  const Point given = own.start ? problem.scaled(started(plan, *own.start, control))
                                : problem.scaled(scaled(plan, joint_values(plan, plan.scene.identify.start, "[identify] start")));
  time.start = seconds_since(begun);
  const Stopwatch watch(time.solve);
  if (plan.solver == Solver::newton && wanted == 0) {
    found.from(given, 0);  // the thesis's scheme as it is
    return;
  }
  const minimise::StartPoints starts({given}, [&](const Point& q) { return problem.misfit(q); });
  const std::size_t most = wanted > 0 ? wanted : minimise::StartPoints::sizes;
  for (std::size_t k = 0; k < most; ++k) {
    found.from(starts(k), k);
    if (wanted == 0 && found.best().converged) break;
  }
}

/// The covariance of the scaled unknowns θ by the scatter of the lines, to first order: H⁻¹ (Σ g_l g_lᵀ) H⁻¹ · L/(L−1) with H = Σ
/// JᵀJ and g_l the gradient of line l less their mean, in the problem as it is weighted.
Eigen::MatrixXd scatter_at(const ResponseProblem& problem, const Point& q) {
  const Eigen::Index n = at(problem.unknowns());
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(n, n);
  std::vector<Eigen::VectorXd> gradients;
  problem.each_line(q, true, [&](const ResponseProblem::Rows& rows) {
    const std::size_t count = rows.columns.size(), equations = rows.f.size();
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::Map<const RowMajor> jacobian(rows.jacobian.data(), at(equations), at(count));
    const Eigen::Map<const Eigen::VectorXd> f(rows.f.data(), at(equations)), factor(rows.factor.data(), at(count));
    const Eigen::MatrixXd own = jacobian * factor.asDiagonal();
    const Eigen::MatrixXd square = own.transpose() * own;
    const Eigen::VectorXd gradient = rows.weight * (own.transpose() * f);
    Eigen::VectorXd whole = Eigen::VectorXd::Zero(n);
    for (std::size_t t = 0; t < count; ++t) {
      whole[at(rows.columns[t])] += gradient[at(t)];
      for (std::size_t u = 0; u < count; ++u) information(at(rows.columns[t]), at(rows.columns[u])) += square(at(t), at(u));
    }
    gradients.push_back(std::move(whole));
  });
  const auto lines = static_cast<double>(gradients.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(n);
  for (const Eigen::VectorXd& gradient : gradients) mean += gradient / lines;
  Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(n, n);
  for (const Eigen::VectorXd& gradient : gradients) scatter += (gradient - mean) * (gradient - mean).transpose();
  const Eigen::MatrixXd inverse = minimise::covariance_of(information);
  const Eigen::VectorXd scale = Eigen::Map<const Eigen::VectorXd>(problem.scale().data(), n);
  return scale.asDiagonal() * (inverse * scatter * inverse) * scale.asDiagonal() * (lines / std::max(1.0, lines - 1.0));
}

/// "K(1,1) reached 5.3e+28 N/m".
std::string largest_unknown(const Point& q, const Solution& out) {
  const auto most =
      std::ranges::max_element(q, {}, [](double each) { return std::isnan(each) ? HUGE_VAL : std::abs(each); }) - q.begin();
  const Estimate& unknown = out.unknowns[static_cast<std::size_t>(most)];
  return unknown.name + " reached " + digits(unknown.value) + " " + unknown.unit;
}

/// What the linearised problem at the end says of rank and condition.
minimise::LinearSolution linearised(ResponseProblem& problem, const Point& q) {
  minimise::Accumulator accumulator(problem.unknowns());
  minimise::Accumulator::Columns all(problem.unknowns());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  problem.weigh_at(q);
  minimise::Triangle& triangle = accumulator.triangle(all);
  problem.each_line(q, true, [&](const ResponseProblem::Rows& rows) { append(rows, triangle); });
  accumulator.flush();
  minimise::LinearSolution linear = minimise::solve_dense(accumulator);
  linear.y = problem.theta(q);
  return linear;
}

/// Fits that no F test at 95 % could tell from the best: Σ F² rises by p/(rows − p) times about two. Below rounding all fit.
double as_good_as(double misfit, std::size_t unknowns, std::size_t rows) {
  const double free = std::max(1.0, static_cast<double>(rows) - static_cast<double>(unknowns));
  return std::max(misfit * (1.0 + 2.0 * static_cast<double>(unknowns) / free), 1e-20);
}

/// Of an estimate that settled, where Detail::full asks for it.
struct Scatter {
  std::optional<Eigen::MatrixXd> covariance;         ///< without constraints
  std::optional<ConstrainedScatter> constrained;
};

void estimate(const Plan& plan, NewtonPlan& own, const Control& control, Solution& out, Scatter& scatter) {
  const Clock::time_point start = Clock::now();
  ResponseProblem problem(own.read_responses(plan, plan.lines.size()), plan.columns->size());
  problem.stop_when(control.interrupted);
  out.runtime_s.read = seconds_since(start);
  out.fit.lines = plan.lines.size();
  out.fit.equations_used = problem.residuals() / 2;
  out.fit.equations_dropped = plan.lines.size() * plan.cost.equations_per_line - out.fit.equations_used;
  if (problem.residuals() == 0) {
    out.status = Status::no_equations;
    out.message =
        "No line has all FRFs between the coordinates used. Choose other lines, or look with `jointid info` at what the files "
        "hold.";
    return;
  }
  Search found(plan, problem, out, control);
  search(plan, own, problem, control, found, out.runtime_s);
  if (found.best().q.empty()) {
    out.status = Status::no_equations;
    out.message = "The FRFs are not defined at any start: H_bb and the start make I + Z H_bb singular on some line.";
    return;
  }
  minimise::LinearSolution linear = linearised(problem, found.best().q);
  if (plan.admissible) out.admissibility = state_constraints(plan, problem, found.best().q, linear);
  interpret(plan, linear, out);
  if (plan.admissible) tell_outcome(plan, out);
  out.fit.iterations = found.iterations();
  if (!found.best().converged) {
    out.status = Status::not_converged;
    out.message = (found.best().diverged ? "The iteration diverged and was stopped: " + largest_unknown(found.best().q, out) + "."
                                         : "The iteration did not converge.") +
                  " Try other starts (starts = 20 in [identify]) or method \"likelihood\".";
  } else if (out.status == Status::ok && control.detail == Detail::full) {
    scatter.covariance = scatter_at(problem, found.best().q);
    if (plan.admissible && control.judgement == Judgement::data)
      scatter.constrained = scatter_under_constraints(*plan.admissible, problem, found.best().q, *scatter.covariance);
  }
  if (plan.scene.identify.starts > 0) {
    out.search = found.minima().result(as_good_as(found.misfit(), problem.unknowns(), problem.residuals()));
    for (FoundMinimum& minimum : out.search->minima) {
      minimum.values = problem.theta(minimum.values);
      for (std::size_t c = 0; c < minimum.values.size(); ++c) minimum.values[c] *= plan.unscale(c);
    }
  }
}

class NewtonMethod final : public NewtonPlan {
 public:
  void solve(const Plan& plan, const Control& control, Solution& out) override {
    Scatter scatter;
    estimate(plan, *this, control, out, scatter);
    tell_and_predict(plan, control, out);
    if (!scatter.covariance || control.judgement != Judgement::data) return;
    const Stopwatch watch(out.runtime_s.check);
    std::vector<double> theta;
    for (std::size_t c = 0; c < out.unknowns.size(); ++c) theta.push_back(out.unknowns[c].value / plan.unscale(c));
    if (plan.admissible) judge_predicted_constraints(plan, theta, scatter.constrained, out);
    else judge_predicted(plan, theta, *scatter.covariance, out);
    judge_unknown_noise(out);
  }
};

}  // namespace

PlannedMethod plan_newton(const Plan& plan, const StartPlanner& plan_start) {
  if (frequencies_are_data(plan.scene)) return plan_loose_by_frequencies(plan);
  return plan_responses(plan, plan_start, std::make_unique<NewtonMethod>());
}

}  // namespace jointid::ident
