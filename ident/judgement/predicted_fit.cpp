#include "ident/judgement/predicted_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "coupling/joint_loop.hpp"
#include "ident/judgement/measured_rectangle.hpp"
#include "ident/plan/joint_impedance.hpp"
#include "minimise/damping.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Errors of FRFs below this part of them are not called a misfit, as those of WhitenedFit.
constexpr double least_share_of_frf = 1e-3;

/// A part of a rectangle at a line: its values, or variances.
template <class Matrix, class Of>
Matrix part_of(std::size_t first_row, std::size_t rows, std::size_t first_column, std::size_t columns, const Of& of) {
  Matrix out(at(rows), at(columns));
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) out(at(r), at(c)) = of(first_row + r, first_column + c);
  }
  return out;
}

PredictedLine predicted_line(const MeasuredRectangle& parts, const MeasuredRectangle& whole, std::size_t line) {
  const std::size_t m = whole.rows, l = whole.columns, n = parts.rows - m;
  const auto value = [&](std::size_t r, std::size_t c) { return parts.value(line, r, c); };
  const auto variance = [&](std::size_t r, std::size_t c) { return parts.variance(line, r, c); };
  PredictedLine out;
  out.aa = part_of<MatrixXcd>(0, m, 0, l, value);
  out.ab = part_of<MatrixXcd>(0, m, l, n, value);
  out.ba = part_of<MatrixXcd>(m, n, 0, l, value);
  out.bb = part_of<MatrixXcd>(m, n, l, n, value);
  out.nn = part_of<MatrixXcd>(0, m, 0, l, [&](std::size_t r, std::size_t c) { return whole.value(line, r, c); });
  out.nn_variance = part_of<MatrixXd>(0, m, 0, l, variance) +
                    part_of<MatrixXd>(0, m, 0, l, [&](std::size_t r, std::size_t c) { return whole.variance(line, r, c); });
  out.ab_variance = part_of<MatrixXd>(0, m, l, n, variance);
  out.ba_variance = part_of<MatrixXd>(m, n, 0, l, variance);
  out.bb_variance = part_of<MatrixXd>(m, n, l, n, variance);
  return out;
}

std::optional<PredictedLines> read_all(const Plan& plan, std::size_t most) {
  const Coordinates& own = plan.coordinates;
  const Dofs rows = joined(own.responses, own.joint), columns = joined(own.references, own.joint);
  const std::vector<Line> chosen = spread_lines(plan.lines, most);
  const std::vector<std::size_t> part_lines = lines_of(chosen, &Line::substructures),
                                 whole_lines = lines_of(chosen, &Line::assembly);
  const auto scene = scene_with_noise(plan, {own.joint, columns, part_lines}, {own.responses, own.references, whole_lines});
  if (!scene) return std::nullopt;
  const MeasuredRectangle parts = read_rectangle(*plan.substructures, rows, columns, *scene, part_lines);
  const MeasuredRectangle whole = read_rectangle(*plan.assembly, own.responses, own.references, *scene, whole_lines);
  PredictedLines out{.lines = {}, .from_knowledge = knows_noise(plan)};
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    out.lines.push_back(predicted_line(parts, whole, i));
    out.lines.back().frequency_hz = chosen[i].frequency_hz;
  }
  return out;
}

/// F of a line with its weights 1/var F, 0 where F is not defined, and the FRFs of the assembly that it is linearised by.
struct PredictedResidual {
  MatrixXcd f, from_joint, to_joint;  ///< F, H_nj, H_jn
  MatrixXd weight;

  double equations() const { return (weight.array() > 0.0).cast<double>().sum(); }
};

PredictedResidual residual_at(const PredictedLine& line, const MatrixXcd& z) {
  PredictedResidual out;
  out.to_joint = coupling::motion_with_joint(line.bb, z, line.ba);
  out.from_joint = coupling::motion_from_joint(line.ab, z, line.bb);
  const MatrixXcd force = z * out.to_joint;  // P H_ba
  out.f = line.nn - line.aa + line.ab * force;
  const MatrixXd right = force.cwiseAbs2(), left = (out.from_joint * z).cwiseAbs2();
  const MatrixXd variance = line.nn_variance + line.ab_variance * right + left * line.ba_variance +
                            left * line.bb_variance * right +
                            least_share_of_frf * least_share_of_frf * (line.nn.cwiseAbs2() + line.aa.cwiseAbs2());
  out.weight = MatrixXd::Zero(out.f.rows(), out.f.cols());
  for (Index i = 0; i < variance.size(); ++i) {
    const double v = variance.data()[i];
    if (std::isfinite(v) && v > 0.0 && std::isfinite(std::norm(out.f.data()[i]))) out.weight.data()[i] = 1.0 / v;
  }
  return out;
}

double weighted_square(const MatrixXcd& f, const MatrixXd& weight) {
  return (weight.array() > 0.0).select(weight.cwiseProduct(f.cwiseAbs2()), 0.0).sum();
}

/// Σ w Re conj(e_k) e_l of a line, the last column being F.
MatrixXd normal_at(const JointImpedance& joint, const PredictedResidual& now) {
  const Index p = at(joint.columns().size()), size = now.f.size();
  MatrixXd rows = MatrixXd::Zero(2 * size, p + 1);
  const auto put = [&](const MatrixXcd& values, Index column) {
    for (Index i = 0; i < size; ++i) {
      const double root = std::sqrt(now.weight.data()[i]);
      if (!(root > 0.0)) continue;
      rows(i, column) = root * values.data()[i].real();
      rows(size + i, column) = root * values.data()[i].imag();
    }
  };
  for (Index k = 0; k < p; ++k) {
    MatrixXcd derivative = MatrixXcd::Zero(now.f.rows(), now.f.cols());
    for (const auto& [row, column, factor] : joint.places(static_cast<std::size_t>(k))) {
      derivative += factor * now.from_joint.col(row) * now.to_joint.row(column);
    }
    put(derivative, k);
  }
  put(now.f, p);
  MatrixXd out = MatrixXd::Zero(p + 1, p + 1);
  out.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  return out.selfadjointView<Eigen::Lower>();
}

/// All lines about one joint.
struct LinesAbout {
  MatrixXd information;
  VectorXd gradient;                ///< Σ Jᵀ W F
  std::vector<VectorXd> by_line;    ///< the gradients
  std::vector<MatrixXd> weights;    ///< by line
  double cost = 0.0, misfit = 0.0;  ///< Σ W|F|², and as PredictedFit
};

class PredictedEquations {
 public:
  PredictedEquations(const Plan& plan, const PredictedLines& data) : data_(data), unknowns_(at(plan.columns->size())) {
    for (const PredictedLine& line : data.lines) {
      joints_.push_back(joint_at(plan.restriction, *plan.columns, plan.omega0, angular(line.frequency_hz)));
    }
  }

  LinesAbout about(const std::vector<double>& theta) const {
    LinesAbout out{MatrixXd::Zero(unknowns_, unknowns_), VectorXd::Zero(unknowns_), {}, {}, 0.0, 0.0};
    std::vector<double> misfits;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      out.weights.emplace_back();
      if (joints_[i].columns().empty()) continue;
      const PredictedResidual now = residual_at(data_.lines[i], joints_[i].at(theta));
      out.weights.back() = now.weight;
      const double equations = now.equations();
      if (!(equations > 0.0)) continue;
      add(joints_[i], normal_at(joints_[i], now), out);
      const double square = weighted_square(now.f, now.weight);
      out.cost += square;
      misfits.push_back(square / equations);
    }
    out.misfit = misfits.empty() ? std::numeric_limits<double>::quiet_NaN() : median(misfits);
    return out;
  }

  /// Σ W|F|² with the weights of another joint; infinite where an equation that they have is not defined.
  double cost(const std::vector<double>& theta, const std::vector<MatrixXd>& weights) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (weights[i].size() == 0) continue;
      sum += weighted_square(residual_at(data_.lines[i], joints_[i].at(theta)).f, weights[i]);
    }
    return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
  }

 private:
  void add(const JointImpedance& joint, const MatrixXd& normal, LinesAbout& to) const {
    const Index p = at(joint.columns().size());
    VectorXd gradient = VectorXd::Zero(unknowns_);
    for (Index k = 0; k < p; ++k) {
      const Index row = at(joint.columns()[static_cast<std::size_t>(k)]);
      gradient[row] += normal(k, p);
      for (Index l = 0; l < p; ++l) to.information(row, at(joint.columns()[static_cast<std::size_t>(l)])) += normal(k, l);
    }
    to.gradient += gradient;
    to.by_line.push_back(std::move(gradient));
  }

  const PredictedLines& data_;
  Index unknowns_;
  std::vector<JointImpedance> joints_;
};

std::vector<double> moved(std::vector<double> theta, const VectorXd& step) {
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] += step[at(i)];
  return theta;
}

/// The step that lowers the cost, by more and more damping; empty where none does.
std::optional<VectorXd> damped_step(const PredictedEquations& equations, const std::vector<double>& theta, const LinesAbout& now,
                                    minimise::Damping& damping) {
  std::optional<VectorXd> found;
  damping.search([&](double value) {
    MatrixXd damped = now.information;
    damped.diagonal() *= 1.0 + value;
    const VectorXd step = -minimise::covariance_of(damped) * now.gradient;
    if (!step.allFinite() || !(equations.cost(moved(theta, step), now.weights) < now.cost)) return false;
    found = step;
    damping.less();
    return true;
  });
  return found;
}

/// H⁻¹ (Σ g_l g_lᵀ) H⁻¹ · L/(L−1).
MatrixXd scatter_of_lines(const LinesAbout& at_end) {
  MatrixXd scatter = MatrixXd::Zero(at_end.information.rows(), at_end.information.cols());
  for (const VectorXd& gradient : at_end.by_line) scatter += gradient * gradient.transpose();
  const MatrixXd inverse = minimise::covariance_of(at_end.information);
  const auto lines = static_cast<double>(at_end.by_line.size());
  return inverse * scatter * inverse * (lines / std::max(1.0, lines - 1.0));
}

/// Reads up to `most` lines, spread over all. Empty where nothing is known of the noise, as read_noisy_lines().
std::optional<PredictedLines> read_predicted_lines(const Plan& plan, std::size_t most) {
  try {
    return read_all(plan, most);
  } catch (const InputError&) {
    return std::nullopt;  // no variances
  }
}

}  // namespace

std::optional<PredictedLines> predicted_lines_to_judge(const Plan& plan) {
  constexpr double flops = 2e9;
  constexpr std::size_t most = 64, least = 6;
  if (!plan.regenerated.empty() || !plan.scene.couple_first.pairs.empty()) return std::nullopt;
  const auto number = [](std::size_t i) { return static_cast<double>(i); };
  const double n = number(plan.coordinates.joint.size()), m = number(plan.coordinates.responses.size()),
               l = number(plan.coordinates.references.size()), p = number(plan.restriction.unknowns.size());
  constexpr double evaluations = 40.0;  // of F and its derivatives
  const double per_line = evaluations * (8.0 * n * n * (n + m + l) + 8.0 * m * l * n + m * l * p * (8.0 + 2.0 * p));
  const auto lines = static_cast<std::size_t>(flops / per_line);
  return lines < least ? std::nullopt : read_predicted_lines(plan, std::min(most, lines));
}

std::optional<PredictedFit> predicted_fit(const Plan& plan, const PredictedLines& data, const std::vector<double>& start) {
  constexpr int most_steps = 20;
  constexpr double near = 1e-3;  // of the standard deviations that the misfit makes
  if (!std::ranges::all_of(start, [](double value) { return std::isfinite(value); })) return std::nullopt;
  const PredictedEquations equations(plan, data);
  PredictedFit fit{.theta = start, .covariance = {}};
  LinesAbout now = equations.about(fit.theta);
  if (now.by_line.empty()) return std::nullopt;
  minimise::Damping damping({.first = 0.0, .least = 1e-4, .most = 1e8, .again = 1e-4});
  bool settled = false;
  for (int k = 0; k < most_steps && !settled; ++k) {
    const auto step = damped_step(equations, fit.theta, now, damping);
    settled = !step || step->dot(now.information * *step) < near * near * std::max(now.misfit, 1e-12);
    if (!step) break;
    fit.theta = moved(fit.theta, *step);
    now = equations.about(fit.theta);
  }
  fit.misfit = now.misfit;
  fit.covariance = scatter_of_lines(now);
  return fit;
}

}  // namespace jointid::ident
