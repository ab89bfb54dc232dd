#include "ident/likelihood/fit/linearised_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/eigen.hpp"
#include "ident/likelihood/fit/godambe_information.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// Shares a cost out: to the ties what they have of it in the quadratic model, the rest by how far each condition pulled the
/// estimate the way it went.
void share_out(const Eigen::VectorXd& free, double cost, double tie_share, AdmissibleFit& fit) {
  std::vector<double> pulls;
  double sum = 0.0;
  for (const Eigen::VectorXd& force : fit.forces) {
    pulls.push_back(force.size() > 0 ? force.dot(fit.theta - free) : 0.0);
    sum += pulls.back();
  }
  fit.cost = cost;
  fit.tie_cost = sum > 0.0 ? tie_share * cost : (tie_share > 0.0 ? cost : 0.0);
  for (std::size_t k = 0; k < pulls.size(); ++k) fit.shares[k] = sum > 0.0 ? (cost - fit.tie_cost) * pulls[k] / sum : 0.0;
}

}  // namespace

Eigen::MatrixXd linearise_at(const std::vector<double>& theta, PenalisedLines& all) {
  all.lines.begin(theta);
  all.lines.relax(theta);
  all.lines.linearise(theta);
  all.lines.weigh_alike();
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  all.sum(theta, information, gradient);
  return information;
}

LinearisedLikelihood LinearisedLikelihood::moved_to(LikelihoodFit other, bool brings_lines) && {
  if (brings_lines) linearise_at(other.theta, all_);
  return {std::move(all_), std::move(other), std::move(memory_), std::move(opinion_)};
}

ConstrainedFit LinearisedLikelihood::constrained(const AdmissibleSet& set, const FitWatcher& watch) && {
  const auto nearest = [&] {
    return nearest_admissible(set, vector_of(fit.theta), minimise::root_of(fit.information), std::sqrt(all_.lines.tolerance()));
  };
  AdmissibleFit unmoved = nearest();
  if (unmoved.theta == vector_of(fit.theta)) return {std::move(*this), std::move(unmoved)};
  const FitListener nobody;
  JointIteration iteration(all_, memory_, opinion_, watch, nobody);
  const std::size_t before = std::exchange(fit.iterations, 0);
  fit.converged = iteration.project(fit, settled) && fit.converged;  // so that both minima are of the same weights
  const double free_loss = all_.total(fit.theta);
  const Eigen::VectorXd free = vector_of(fit.theta);
  Constraint within{set, nearest()};
  const bool moves = within.nearest.theta != free;
  const double tie_share = within.nearest.cost > 0.0 ? within.nearest.tie_cost / within.nearest.cost : 0.0;
  if (moves) {
    fit.theta.assign(within.nearest.theta.begin(), within.nearest.theta.end());
    fit.converged = iteration.project(fit, settled, JointIteration::From::anywhere, nullptr, &within) && within.nearest.converged;
  }
  fit.iterations += before;
  all_.finish(fit);
  ConstrainedFit out{std::move(*this), std::move(within.nearest)};
  out.admissible.theta = vector_of(out.fitted.fit.theta);
  share_out(free, moves ? std::max(0.0, out.fitted.fit.loss - free_loss) : 0.0, tie_share, out.admissible);
  return out;
}

LinearisedLikelihood::NearbyGradients LinearisedLikelihood::begin_godambe() const {
  if (all_.lines.layout().is_large()) return {};
  return {first_offsets(fit.information), std::vector<Eigen::MatrixXd>(all_.lines.snapshot().size())};
}

void LinearisedLikelihood::take_nearby(std::size_t line, LineModel& model, NearbyGradients& to) const {
  to.of_lines[line] = all_.lines.gradients_nearby(line, fit.theta, to.offsets, model);
}

Eigen::MatrixXd LinearisedLikelihood::godambe_information(NearbyGradients begun) {
  const bool saves = all_.lines.layout().is_large();  // and moves the lines
  std::vector<FittedLine> kept;
  if (saves) kept = all_.lines.snapshot();
  const std::vector<FittedLine>& there = saves ? kept : all_.lines.snapshot();
  const auto exact = [&](const std::vector<Eigen::VectorXd>& offsets) {
    const bool is_begun = offsets == std::exchange(begun.offsets, {});
    const Eigen::MatrixXd sums = all_.lines.gradients_nearby(
        there, fit.theta, offsets, is_begun ? std::move(begun.of_lines) : std::vector<Eigen::MatrixXd>());
    std::vector<Eigen::VectorXd> out;
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      out.emplace_back(sums.col(at(k)));
      for (const auto& [column, value, weight] : all_.priors) {
        out.back()[at(column)] += weight * weight * (value - fit.theta[column] - offsets[k][at(column)]);
      }
    }
    return out;
  };
  const auto quick = [&](const Eigen::VectorXd& offset) {
    std::vector<double> theta = fit.theta;
    for (std::size_t i = 0; i < theta.size(); ++i) theta[i] += offset[at(i)];
    all_.lines.answer(there, theta, offset);
    all_.lines.take_gradients(theta);
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    all_.sum(theta, information, gradient);
    return gradient;
  };
  Eigen::MatrixXd curvature = jointid::ident::godambe_information(exact, fit.information, saves ? GradientAt(quick) : GradientAt());
  if (saves) all_.lines.restore(std::move(kept));
  return curvature;
}

Eigen::MatrixXd LinearisedLikelihood::information_of(std::size_t line) const {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(at(all_.unknowns), at(all_.unknowns));
  all_.lines.add_information(line, 1.0, information);
  return information;
}

}  // namespace jointid::ident
