#include "ident/likelihood/fit/penalised_lines.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"

namespace jointid::ident {

double PenalisedLines::total(const std::vector<double>& theta) const {
  double sum = lines.loss();
  for (const auto& [column, value, weight] : priors) sum += weight * weight * (value - theta[column]) * (value - theta[column]);
  return sum;
}

void PenalisedLines::sum(const std::vector<double>& theta, Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const {
  information = Eigen::MatrixXd::Zero(at(unknowns), at(unknowns));
  gradient = Eigen::VectorXd::Zero(at(unknowns));
  for (const auto& [column, value, weight] : priors) {
    information(at(column), at(column)) += weight * weight;
    gradient[at(column)] += weight * weight * (value - theta[column]);
  }
  lines.add_to(information, gradient);
}

double PenalisedLines::misfit_of(double loss) const {
  constexpr double least_misfit = 1e-6;
  const double expected = lines.expected() - static_cast<double>(unknowns);
  return expected > 0.0 ? std::clamp(std::sqrt(loss / expected), least_misfit, 1.0) : 1.0;
}

bool PenalisedLines::are_far_from_fitting() const {
  constexpr double far_misfit = 9.0;
  return lines.tolerance() > far_misfit;
}

void PenalisedLines::finish(LikelihoodFit& fit) const {
  fit.loss = total(fit.theta);
  fit.line_cost.clear();
  fit.line_weight.clear();
  for (const FittedLine& line : lines.snapshot()) {
    fit.line_cost.push_back(line.cost);
    fit.line_weight.push_back(line.weight);
  }
  fit.bytes = lines.bytes();
}

bool SecondOpinion::is_beyond_any_joint(const PenalisedLines& all, const std::vector<double>& theta) {
  if (!ask_ || !all.are_far_from_fitting()) return false;
  if (!said_) said_ = ask_({theta.begin(), theta.begin() + std::ptrdiff_t(all.joint_unknowns)});
  return *said_;
}

}  // namespace jointid::ident
