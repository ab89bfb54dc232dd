#include "impedance/line/line_fit.hpp"

#include <algorithm>
#include <cmath>

#include "dense/cholesky.hpp"
#include "ident/likelihood/model/guess_y.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::impedance {
namespace {

constexpr std::size_t most_steps = 100;
constexpr double longest = 10.0;       // of a step, in |z|
constexpr double by_rounding = 1e-13;  // of χ²

std::vector<double> unknowns_of(const Eigen::VectorXcd& z) {
  std::vector<double> out;
  for (Eigen::Index t = 0; t < z.size(); ++t) out.push_back(z(t).real());
  for (Eigen::Index t = 0; t < z.size(); ++t) out.push_back(z(t).imag());
  return out;
}

Eigen::VectorXcd values_of(const std::vector<double>& theta) {
  const std::size_t count = theta.size() / 2;
  Eigen::VectorXcd z(static_cast<Eigen::Index>(count));
  for (std::size_t t = 0; t < count; ++t) z(static_cast<Eigen::Index>(t)) = {theta[t], theta[count + t]};
  return z;
}

/// The largest step of an element over the largest of its own, its unit being that of others: of Re and Im together.
double length_of(const Eigen::VectorXd& step, const std::vector<double>& theta) {
  const Eigen::Index count = step.size() / 2;
  double most = 0.0, size = 0.0;
  for (Eigen::Index t = 0; t < count; ++t) {
    const auto k = static_cast<std::size_t>(t);
    size = std::hypot(theta[k], theta[static_cast<std::size_t>(count) + k]);
    if (size > 0.0) most = std::max(most, std::hypot(step(t), step(count + t)) / size);
  }
  return most;
}

/// By Cholesky where that keeps digits enough, else the step of the directions that have information.
Eigen::VectorXd step_of(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) {
  constexpr double enough = 1e-13;
  const Eigen::VectorXd unit = information.diagonal().cwiseSqrt().cwiseInverse();
  if (unit.allFinite()) {
    const auto solved = dense::solve_definite(unit.asDiagonal() * information * unit.asDiagonal(), unit.cwiseProduct(gradient));
    if (solved && solved->reciprocal_condition > enough) return unit.cwiseProduct(solved->x);
  }
  return minimise::determined_step(information, gradient);
}

/// The FRFs and z of a line on the way.
class Descent {
 public:
  Descent(const ident::LineData& data, const ident::JointImpedance& joint, const Eigen::VectorXcd& start, ident::LineModel& model)
      : data_(data), joint_(joint), model_(model), theta_(unknowns_of(start)) {
    state_ = ident::measured_start(model.layout(), data);
    ident::guess_y(model.layout(), data, joint.at(theta_), state_);
    cost_ = cost_at(theta_, state_);
  }

  LineFit run(double tolerance) {
    tolerance_ = tolerance;
    LineFit out;
    double damping = 0.0;
    while (out.steps < most_steps && std::isfinite(cost_)) {
      ++out.steps;
      if (!linearise(damping)) {
        damping = std::max(10.0 * damping, 1e-3);
        if (damping > 1e12) break;
        continue;
      }
      const Eigen::VectorXd step = step_of(damped(damping), reduced_.gradient);
      out.last_step = std::sqrt(std::max(0.0, step.dot(reduced_.information * step)));
      const double before = cost_;
      if (take(step)) {
        damping = damping > 1e-6 ? 0.1 * damping : 0.0;
        if (damping == 0.0 && (out.last_step < tolerance || before - cost_ <= by_rounding * std::max(1.0, cost_))) break;
      } else {
        if (out.last_step < 1e-6) break;
        damping = std::max(10.0 * damping, 1e-3);
        if (damping > 1e12) break;
      }
    }
    finish(out);
    return out;
  }

 private:
  double cost_at(const std::vector<double>& theta, const ident::LineState& state) const {
    return ident::line_cost(model_.layout(), data_, joint_.at(theta), state.sub_jn, state.sub_jj);
  }

  bool linearise(double damping) {
    const ident::ComplexMatrix z = joint_.at(theta_);
    ident::put_on_constraint(model_.layout(), z, state_);
    model_.linearise(data_, joint_, z, state_, true);
    auto reduced = model_.reduce(damping);
    if (!reduced) return false;
    reduced_ = std::move(*reduced);
    return true;
  }

  Eigen::MatrixXd damped(double damping) const {
    Eigen::MatrixXd out = reduced_.information;
    out.diagonal() *= 1.0 + damping;
    return out;
  }

  /// Steps beyond ten times |z| are shortened; where χ² rises nothing moves.
  bool take(const Eigen::VectorXd& step) {
    const double length = length_of(step, theta_), scale = length > longest ? longest / length : 1.0;
    std::vector<double> theta = theta_;
    for (std::size_t t = 0; t < theta.size(); ++t) theta[t] += scale * step(static_cast<Eigen::Index>(t));
    ident::LineState state = state_;
    ident::move(model_.layout(), reduced_.own + reduced_.answer(step), scale, state.sub_jn, state.sub_jj);
    const double cost = cost_at(theta, state);
    if (!(cost <= cost_ * (1.0 + by_rounding))) return false;
    theta_ = std::move(theta);
    state_ = std::move(state);
    cost_ = cost;
    return true;
  }

  void finish(LineFit& out) {
    const bool has_information = linearise(0.0);
    out.value.z = values_of(theta_);
    const Eigen::MatrixXd none =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(theta_.size()), static_cast<Eigen::Index>(theta_.size()));
    out.value.covariance = minimise::covariance_of(has_information ? reduced_.information : none);
    out.value.chi_square = cost_;
    out.value.freedom = data_.redundancy(model_.layout()) - static_cast<double>(theta_.size());
    out.state = state_;
    out.converged = has_information && std::isfinite(cost_) && out.last_step < std::max(1e-3, tolerance_);
  }

  const ident::LineData& data_;
  const ident::JointImpedance& joint_;
  ident::LineModel& model_;
  std::vector<double> theta_;
  ident::LineState state_;
  ident::ReducedLine reduced_;
  double cost_ = 0.0, tolerance_ = 0.0;
};

}  // namespace

LineFit fit_line(const ident::LineData& data, const ident::JointImpedance& joint, const Eigen::VectorXcd& start,
                 ident::LineModel& model, double tolerance) {
  return Descent(data, joint, start, model).run(tolerance);
}

std::optional<double> fall_with(const ident::LineData& data, const ident::JointImpedance& wider, const Eigen::VectorXcd& z,
                                const LineFit& fit, ident::LineModel& model) {
  model.linearise(data, wider, wider.at(unknowns_of(z)), fit.state, true);
  const auto reduced = model.reduce(0.0, false);
  if (!reduced) return std::nullopt;
  return step_of(reduced->information, reduced->gradient).dot(reduced->gradient);
}

}  // namespace jointid::impedance
