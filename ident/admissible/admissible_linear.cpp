#include "ident/admissible/admissible_linear.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/admissible/outcome.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/reduced_system.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

void tell_rank(const AdmissibleFit& fit, minimise::LinearSolution& linear) {
  linear.rank = linear.y.size() - static_cast<std::size_t>(fit.null_space.cols());
  linear.condition = fit.condition;
  linear.free_directions.clear();
  linear.undetermined.clear();
  if (fit.null_space.cols() > 0) minimise::tell_null_space(fit.null_space, linear);
}

}  // namespace

Admissibility constrain(const Plan& plan, const minimise::Accumulator& accumulator, std::size_t rows,
                        minimise::LinearSolution& linear, bool& converged) {
  const Eigen::MatrixXd system = minimise::reduced_system(accumulator);
  const Index n = system.cols() - 1;
  const Eigen::MatrixXd root = system.leftCols(n);
  const VectorXd theta = Eigen::Map<const VectorXd>(linear.y.data(), n);
  const double residual = (root * theta - system.col(n)).norm();
  const bool measurable = rows > linear.y.size();
  const double deviation = measurable ? residual / std::sqrt(static_cast<double>(rows - linear.y.size())) : 0.0;
  const double unit = std::max(deviation, 1e-11 * system.col(n).norm());  // exact data: as far as arithmetic goes
  const AdmissibleFit fit = nearest_admissible(*plan.admissible, theta, root, unit);
  converged = fit.converged;
  linear.y.assign(fit.theta.begin(), fit.theta.end());
  linear.residual_norm = (root * fit.theta - system.col(n)).norm();
  if (!plan.admissible->ties.empty()) tell_rank(fit, linear);
  return outcome_of(*plan.admissible, fit, measurable ? unit : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace jointid::ident
