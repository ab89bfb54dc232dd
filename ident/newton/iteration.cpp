#include "ident/newton/iteration.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "base/eigen.hpp"
#include "dense/pivoted_qr.hpp"
#include "minimise/damping.hpp"

namespace jointid::ident {
namespace {

std::vector<double> added(const std::vector<double>& q, const Eigen::VectorXd& step) {
  std::vector<double> sum = q;
  for (std::size_t i = 0; i < q.size(); ++i) sum[i] += step[at(i)];
  return sum;
}

/// min ‖J s + F‖² of the lines used, reduced line by line to R s ≈ b; memory does not grow with the lines.
class Linearised {
 public:
  Linearised(const ResponseProblem& problem, std::span<const double> q) : unknowns_(at(problem.unknowns())) {
    minimise::Triangle triangle(problem.unknowns());
    defined = problem.each_line(q, true, [&](const ResponseProblem::Rows& rows) { append(rows, triangle); });
    triangle.flush();
    free_ = static_cast<double>(triangle.rows_pushed()) - static_cast<double>(problem.unknowns());
    r_ = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
    b_ = Eigen::VectorXd(unknowns_);
    for (Eigen::Index i = 0; i < unknowns_; ++i) {
      for (Eigen::Index j = i; j < unknowns_; ++j) r_(i, j) = triangle(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
      b_[i] = triangle(static_cast<std::size_t>(i), problem.unknowns());
    }
    rest_ = std::pow(triangle(problem.unknowns(), problem.unknowns()), 2);
    sizes_ = r_.colwise().norm().transpose();
    largest_ = sizes_.maxCoeff();
    for (double& size : sizes_) size = std::max(size, 1e-8 * largest_);  // an unknown without effect stays where it is
  }

  double cost() const { return rest_ + b_.squaredNorm(); }

  /// The next step would be below 1e-3 of the standard deviations that the residuals tell.
  bool settled() const { return free_ > 0.0 && b_.squaredNorm() < 1e-6 * rest_ / free_; }

  /// Factors of RᵀR + λ diag(RᵀR).
  void damp(double lambda) {
    Eigen::MatrixXd stacked(2 * unknowns_, unknowns_);
    stacked << r_, Eigen::MatrixXd((std::sqrt(lambda) * sizes_).asDiagonal());
    qr_.emplace(stacked);
  }

  Eigen::VectorXd step() const {
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * unknowns_);
    right.head(unknowns_) = b_;
    return qr_->solve(right);
  }

  /// (RᵀR + λ diag)⁻¹ v
  Eigen::VectorXd solve(const Eigen::VectorXd& v) const {
    const Eigen::MatrixXd r = qr_->triangle();
    const auto triangle = r.triangularView<Eigen::Upper>();
    Eigen::VectorXd x = qr_->permutation().transpose() * v;
    triangle.transpose().solveInPlace(x);
    triangle.solveInPlace(x);
    return qr_->permutation() * x;
  }

  const Eigen::MatrixXd& triangle() const { return r_; }

  /// Length of a step by the sizes of the columns.
  double length(const Eigen::VectorXd& step) const { return step.cwiseProduct(sizes_).norm(); }

  bool defined = false;

 private:
  Eigen::Index unknowns_;
  double free_ = 0.0, rest_ = 0.0, largest_ = 0.0;
  Eigen::MatrixXd r_;
  Eigen::VectorXd b_, sizes_;
  std::optional<dense::RealPivotedQr> qr_;
};

/// Jᵀ of the second derivative of F along a step, from F a little way along it.
std::optional<Eigen::VectorXd> curvature(const ResponseProblem& problem, const std::vector<double>& q, const Eigen::VectorXd& step) {
  constexpr double way = 0.1;
  std::vector<double> ahead;
  const auto note = [&](const ResponseProblem::Rows& rows) {
    std::ranges::transform(rows.f, std::back_inserter(ahead), [&](double f) { return rows.weight * f; });
  };
  if (!problem.each_line(added(q, way * step), false, note)) return std::nullopt;
  Eigen::VectorXd out = Eigen::VectorXd::Zero(at(q.size()));
  auto there = ahead.begin();
  std::vector<double> along, sum;  // of the line's own unknowns
  const bool defined = problem.each_line(q, true, [&](const ResponseProblem::Rows& rows) {
    const std::size_t count = rows.columns.size();
    along.clear();
    for (std::size_t t = 0; t < count; ++t) along.push_back(rows.factor[t] * step[at(rows.columns[t])]);
    sum.assign(count, 0.0);
    for (std::size_t i = 0; i < rows.f.size(); ++i) {
      const double* row = rows.jacobian.data() + i * count;
      const double slope = std::inner_product(along.begin(), along.end(), row, 0.0);
      const double second = 2.0 / way * ((*there++ - rows.weight * rows.f[i]) / way - slope);
      for (std::size_t t = 0; t < count; ++t) sum[t] += row[t] * second;
    }
    for (std::size_t t = 0; t < count; ++t) out[at(rows.columns[t])] += rows.factor[t] * sum[t];
  });
  if (!defined || !out.allFinite()) return std::nullopt;
  return out;
}

/// A damped step with its geodesic acceleration where that is shorter than three quarters of it.
Eigen::VectorXd accelerated(const ResponseProblem& problem, const std::vector<double>& q, const Linearised& lines) {
  const Eigen::VectorXd step = lines.step();
  const auto bent = curvature(problem, q, step);
  if (!bent) return step;
  const Eigen::VectorXd acceleration = -0.5 * lines.solve(*bent);
  return lines.length(acceleration) < 0.75 * lines.length(step) ? Eigen::VectorXd(step + acceleration) : step;
}

bool is_tiny(const Eigen::VectorXd& step, const std::vector<double>& q, double share) {
  double largest = 0.0;
  for (const double each : q) largest = std::max(largest, std::abs(each));
  return step.cwiseAbs().maxCoeff() <= share * largest;
}

/// Both schemes: weights and lines where the step begins, `advance` takes it; it says whether it could.
NewtonFit iterate(ResponseProblem& problem, std::vector<double> start, const NewtonOptions& options,
                  const std::function<std::optional<Eigen::VectorXd>(const std::vector<double>& q, Linearised& lines)>& advance) {
  constexpr double gain = 0.01;
  NewtonFit fit{.q = std::move(start)};
  double misfit = std::numeric_limits<double>::infinity();
  std::size_t since = 0;  // it was that much more
  while (fit.iterations < options.most_iterations && !(options.patience && since >= *options.patience)) {
    if (options.watch) options.watch(fit.q);
    ++fit.iterations;
    problem.weigh_at(fit.q);
    if (options.patience) {
      const double here = problem.misfit(fit.q);
      since = here < (1.0 - gain) * misfit ? 0 : since + 1;
      if (since == 0) misfit = here;
    }
    problem.select_at(fit.q, options.draw);
    Linearised lines(problem, fit.q);
    if (!lines.defined || !std::isfinite(lines.cost())) break;
    if (lines.settled()) {
      fit.converged = true;
      break;
    }
    const auto step = advance(fit.q, lines);
    if (!step) {
      lines.damp(0.0);
      fit.converged = is_tiny(lines.step(), fit.q, 1e-7);  // rounding hides what a step would gain
      break;
    }
    fit.q = added(fit.q, *step);
    fit.diverged = runs_away(fit.q);
    if (fit.diverged) break;
    if (is_tiny(*step, fit.q, 1e-10)) {
      fit.converged = true;
      break;
    }
  }
  problem.select_all();
  return fit;
}

}  // namespace

bool runs_away(std::span<const double> q) {
  constexpr double far = 1e12;
  return std::ranges::any_of(q, [](double each) { return !(std::abs(each) <= far); });
}

void append(const ResponseProblem::Rows& rows, minimise::Triangle& triangle) {
  const std::size_t count = rows.columns.size(), stride = triangle.stride(), unknowns = triangle.unknowns();
  const std::size_t* const columns = rows.columns.data();
  const double *const factor = rows.factor.data(), *jacobian = rows.jacobian.data();
  double* row = triangle.append(rows.f.size());
  for (std::size_t i = 0; i < rows.f.size(); ++i, row += stride, jacobian += count) {
    for (std::size_t t = 0; t < count; ++t) row[columns[t]] = factor[t] * jacobian[t];
    row[unknowns] = -rows.weight * rows.f[i];
  }
}

NewtonFit damped_newton(ResponseProblem& problem, std::vector<double> start, const NewtonOptions& options) {
  constexpr minimise::DampingRange range = {.first = 1e-2, .least = 1e-14, .most = 1e12, .again = 1e-14};
  minimise::Damping damping(range);
  return iterate(problem, std::move(start), options,
                 [&](const std::vector<double>& q, Linearised& lines) -> std::optional<Eigen::VectorXd> {
                   Eigen::VectorXd step;
                   const bool lowers = damping.search([&](double value) {
                     lines.damp(value);
                     step = accelerated(problem, q, lines);
                     return problem.cost(added(q, step)) < lines.cost();
                   });
                   if (!lowers) {
                     damping = minimise::Damping(range);
                     return std::nullopt;
                   }
                   damping.less();
                   return step;
                 });
}

NewtonFit divided_newton(ResponseProblem& problem, std::vector<double> start, const NewtonOptions& options) {
  return iterate(problem, std::move(start), options,
                 [&](const std::vector<double>& q, Linearised& lines) -> std::optional<Eigen::VectorXd> {
                   lines.damp(0.0);
                   Eigen::VectorXd step = lines.step();
                   for (int division = 0; division < 15; ++division, step /= 5.0) {
                     if (problem.cost(added(q, step)) < lines.cost()) return step;
                   }
                   return std::nullopt;
                 });
}

RoundCoordinates::RoundCoordinates(ResponseProblem& problem, std::vector<double> centre) : centre_(std::move(centre)) {
  problem.weigh_at(centre_);
  const Linearised lines(problem, centre_);
  r_ = lines.triangle();
  const double least = 1e-8 * r_.diagonal().cwiseAbs().maxCoeff();
  for (double& pivot : r_.diagonal()) {
    if (std::abs(pivot) < least) pivot = least;
  }
  const Eigen::Map<const Eigen::VectorXd> from(centre_.data(), r_.rows());
  size_ = (r_ * from).norm();
}

std::vector<double> RoundCoordinates::point(std::span<const double> x) const {
  Eigen::VectorXd step = Eigen::Map<const Eigen::VectorXd>(x.data(), r_.rows());
  r_.triangularView<Eigen::Upper>().solveInPlace(step);
  return added(centre_, step);
}

NewtonFit in_rounds(ResponseProblem& problem, std::vector<double> start,
                    const std::function<minimise::Minimum(std::span<const double>)>& minimum, const NewtonOptions& options) {
  constexpr int most_rounds = 40;
  NewtonFit fit{.q = std::move(start)};
  for (int round = 0; round < most_rounds && !fit.converged; ++round) {
    if (options.watch) options.watch(fit.q);
    problem.weigh_at(fit.q);
    problem.distrust_outliers(fit.q);
    problem.select_at(fit.q, options.draw);
    const minimise::Minimum found = minimum(fit.q);
    fit.iterations += found.iterations;
    Eigen::VectorXd step(at(fit.q.size()));
    for (std::size_t i = 0; i < fit.q.size(); ++i) step[at(i)] = found.q[i] - fit.q[i];
    fit.q = found.q;
    fit.diverged = runs_away(fit.q);
    if (fit.diverged) break;
    fit.converged = is_tiny(step, fit.q, 1e-10);
  }
  problem.select_all();
  return fit;
}

}  // namespace jointid::ident
