#include "ident/newton/constrained_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/pivoted_qr.hpp"
#include "ident/admissible/admissible_linear.hpp"
#include "ident/admissible/outcome.hpp"
#include "minimise/damping.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd as_vector(const std::vector<double>& values) { return Eigen::Map<const VectorXd>(values.data(), at(values.size())); }

/// min ‖R s − b‖² + rest over steps s of θ, of the lines used at a point.
class LinearisedLines {
 public:
  LinearisedLines(const ResponseProblem& problem, const std::vector<double>& q) : n_(at(problem.unknowns())) {
    minimise::Triangle triangle(problem.unknowns());
    defined = problem.each_line(q, true, [&](const ResponseProblem::Rows& rows) { append(rows, triangle); });
    triangle.flush();
    root_ = MatrixXd::Zero(n_, n_);
    right_ = VectorXd(n_);
    for (Index i = 0; i < n_; ++i) {
      const auto row = static_cast<std::size_t>(i);
      for (Index j = i; j < n_; ++j)
        root_(i, j) = triangle(row, static_cast<std::size_t>(j)) / problem.scale()[static_cast<std::size_t>(j)];
      right_[i] = triangle(row, problem.unknowns());
    }
    rest_ = std::pow(triangle(problem.unknowns(), problem.unknowns()), 2);
    free_ = static_cast<double>(triangle.rows_pushed()) - static_cast<double>(problem.unknowns());
    defined = defined && root_.allFinite() && right_.allFinite();
  }

  double cost() const { return rest_ + right_.squaredNorm(); }

  /// Standard deviation of a residual; exact data: as far as arithmetic goes.
  double unit() const { return std::max(free_ > 0.0 ? std::sqrt(rest_ / free_) : 0.0, 1e-11 * std::sqrt(cost()) + 1e-300); }
  bool is_measurable() const { return free_ > 0.0; }

  /// R over √λ·its column norms, and the step that it makes least.
  MatrixXd damped(double lambda, VectorXd& step) const {
    VectorXd sizes = root_.colwise().norm().transpose();
    sizes = sizes.cwiseMax(1e-8 * sizes.maxCoeff());  // an unknown without effect stays where it is
    MatrixXd stacked(2 * n_, n_);
    stacked << root_, MatrixXd((std::sqrt(lambda) * sizes).asDiagonal());
    VectorXd right = VectorXd::Zero(2 * n_);
    right.head(n_) = right_;
    step = dense::RealPivotedQr(stacked).solve(right);
    return stacked;
  }

  double length(const VectorXd& step) const { return (root_ * step).norm(); }

  bool defined = false;

 private:
  Index n_;
  MatrixXd root_;
  VectorXd right_;
  double rest_ = 0.0, free_ = 0.0;
};

std::vector<double> scaled(const ResponseProblem& problem, const VectorXd& theta) {
  return problem.scaled({theta.begin(), theta.end()});
}

constexpr double least_damping = 1e-14;

}  // namespace

NewtonFit constrained_newton(ResponseProblem& problem, const AdmissibleSet& set, const std::vector<double>& start,
                             const NewtonOptions& options, std::size_t iterations) {
  constexpr minimise::DampingRange range = {.first = 1e-2, .least = least_damping, .most = 1e12, .again = least_damping};
  NewtonFit fit{.q = start, .iterations = iterations};
  minimise::Damping damping(range);
  bool is_inside = false;
  for (std::size_t step = 0; step < options.most_iterations; ++step) {
    problem.weigh_at(fit.q);
    problem.select_at(fit.q);
    const LinearisedLines model(problem, fit.q);
    if (!model.defined) break;
    const VectorXd theta = as_vector(problem.theta(fit.q));
    VectorXd full;
    if (!is_inside) {
      const AdmissibleFit nearest = nearest_admissible(set, theta, model.damped(least_damping, full), model.unit());
      is_inside = true;
      if (nearest.theta != theta) {
        fit.q = scaled(problem, nearest.theta);
        continue;
      }
    }
    if (options.watch) options.watch(fit.q);
    ++fit.iterations;
    const auto towards = [&](double lambda) -> VectorXd {
      const MatrixXd root = model.damped(lambda, full);
      return nearest_admissible(set, theta + full, root, model.unit()).theta;
    };
    const VectorXd whole = towards(least_damping) - theta;
    if (model.length(whole) <= 1e-3 * model.unit() || whole.cwiseAbs().maxCoeff() <= 1e-9 * theta.cwiseAbs().maxCoeff()) {
      fit.converged = true;
      break;
    }
    std::vector<double> next;
    const bool lowers = damping.search([&](double lambda) {
      next = scaled(problem, towards(lambda));
      return problem.cost(next) < model.cost();
    });
    if (!lowers) {  // rounding, and the precision of the nearest joint, hide what a step would gain
      fit.converged =
          model.length(whole) <= 1e-2 * model.unit() || whole.cwiseAbs().maxCoeff() <= 1e-6 * theta.cwiseAbs().maxCoeff();
      break;
    }
    damping.less();
    fit.q = next;
    fit.diverged = runs_away(fit.q);
    if (fit.diverged) break;
  }
  problem.select_all();
  return fit;
}

std::optional<ConstrainedScatter> scatter_under_constraints(const AdmissibleSet& set, ResponseProblem& problem,
                                                            const std::vector<double>& q, const MatrixXd& covariance) {
  const LinearisedLines model(problem, q);
  if (!model.defined) return std::nullopt;
  VectorXd step;
  const MatrixXd root = model.damped(0.0, step);
  return constrained_scatter(set, as_vector(problem.theta(q)) + step, covariance, root, model.unit());
}

Admissibility state_constraints(const Plan& plan, ResponseProblem& problem, const std::vector<double>& q,
                                minimise::LinearSolution& linear) {
  problem.weigh_at(q);
  problem.select_at(q);
  const LinearisedLines model(problem, q);
  VectorXd step;
  const MatrixXd root = model.damped(0.0, step);
  const VectorXd theta = as_vector(problem.theta(q));
  const AdmissibleFit fit = nearest_admissible(*plan.admissible, theta + step, root, model.unit());
  problem.select_all();
  if (!plan.admissible->ties.empty()) tell_rank(fit, linear);
  return outcome_of(*plan.admissible, fit, model.is_measurable() ? model.unit() : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace jointid::ident
