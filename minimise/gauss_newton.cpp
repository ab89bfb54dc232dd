#include "minimise/gauss_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dense/minimum_norm.hpp"
#include "minimise/damping.hpp"

namespace jointid::minimise {
namespace {

constexpr double longest_step = 1.0;  ///< as GaussNewtonEnd begins with
constexpr double no_gain = 1e-10;          ///< of Σr²: steps are no longer judged by it
constexpr double step_of_rounding = 1e-6;  ///< where Σr² cannot fall any more

double largest_element(const Eigen::VectorXd& step) { return step.size() == 0 ? 0.0 : step.cwiseAbs().maxCoeff(); }

/// A damped step that lowers Σr², more and more damped; false when there is none.
bool descend(const Residuals& residuals, GaussNewtonResult& result, Damping& damping) {
  const double cost = result.at.residual.squaredNorm();
  return damping.search([&](double value) {
    const Eigen::VectorXd tried = result.unknowns + damped_step(result.at, value);
    std::optional<Linearised> next = residuals(tried);
    if (!next || !(next->residual.squaredNorm() < cost)) return false;
    result.unknowns = tried;
    result.at = std::move(*next);
    damping.less();
    return true;
  });
}

}  // namespace

Linearised stacked(const std::vector<Eigen::MatrixXd>& parts) {
  Eigen::Index rows = 0;
  for (const Eigen::MatrixXd& part : parts) rows += part.rows();
  const Eigen::Index columns = parts.empty() ? 1 : parts.front().cols();
  Linearised all = {Eigen::VectorXd(rows), Eigen::MatrixXd(rows, columns - 1)};
  Eigen::Index row = 0;
  for (const Eigen::MatrixXd& part : parts) {
    all.jacobian.middleRows(row, part.rows()) = part.leftCols(columns - 1);
    all.residual.segment(row, part.rows()) = part.rightCols(1);
    row += part.rows();
  }
  return all;
}

Eigen::VectorXd damped_step(const Linearised& at, double damping) {
  const Eigen::Index rows = at.jacobian.rows(), columns = at.jacobian.cols();
  Eigen::VectorXd scale = at.jacobian.colwise().norm().transpose();
  scale = (scale.array() > 0.0).select(scale, 1.0);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(rows + columns, columns);
  system.topRows(rows) = at.jacobian * scale.cwiseInverse().asDiagonal();
  system.bottomRows(columns).diagonal().setConstant(std::sqrt(damping));
  Eigen::VectorXd right = Eigen::VectorXd::Zero(rows + columns);
  right.head(rows) = -at.residual;
  Eigen::VectorXd step = dense::RealMinimumNorm(system).solve(right).cwiseQuotient(scale);
  const double size = largest_element(step);
  if (size > longest_step) step *= longest_step / size;
  return step;
}

GaussNewtonEnd::What GaussNewtonEnd::judge(const Eigen::VectorXd& full, double deviations, double cost, double gain) {
  if (deviations <= options_.enough && gain <= options_.enough) return What::here;
  size_ = largest_element(full);
  shrinks_ = size_ < before_;
  is_last_ = size_ <= options_.tolerance || !shrinks_;
  before_ = size_;
  return size_ <= options_.tolerance || gain <= no_gain * cost ? What::full_step : What::descend;
}

bool GaussNewtonEnd::at_rounding() const { return size_ <= step_of_rounding; }

GaussNewtonResult gauss_newton(const Residuals& residuals, const Eigen::VectorXd& start, const GaussNewtonOptions& options) {
  GaussNewtonResult result;
  result.unknowns = start;
  std::optional<Linearised> first = residuals(start);
  if (!first) return result;
  result.defined = true;
  result.at = std::move(*first);
  Damping damping;
  GaussNewtonEnd end(options);
  for (; result.steps < options.most_steps; ++result.steps) {
    const Eigen::VectorXd full = damped_step(result.at, 0.0), changed = result.at.jacobian * full;
    const auto what = end.judge(full, changed.norm(), result.at.residual.squaredNorm(), changed.squaredNorm());
    if (what == GaussNewtonEnd::What::here) {
      result.converged = true;
      return result;
    }
    if (what == GaussNewtonEnd::What::descend) {
      if (descend(residuals, result, damping)) continue;
      result.converged = end.at_rounding();
      return result;
    }
    std::optional<Linearised> next = residuals(result.unknowns + full);
    if (!next) return result;
    if (end.shrinks()) {
      result.unknowns += full;
      result.at = std::move(*next);
    }
    result.converged = end.is_last();
    if (result.converged) return result;
  }
  return result;
}

}  // namespace jointid::minimise
