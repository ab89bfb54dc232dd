#include "ident/judgement/whitened_fit.hpp"

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "ident/judgement/line_jackknife.hpp"
#include "ident/plan/joint_impedance.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// Errors of FRFs below this part of them are not called a misfit: axes, units and single precision are no better.
constexpr double least_relative_error = 1e-3;

/// P and Q with the shares of C in them, and the residuals and weights 1/var of a line; weight 0: not an equation.
struct LineResidual {
  MatrixXcd z, p, q, r;
  MatrixXd weight;
};

MatrixXcd shifted_p(const NoisyLines& data, MatrixXcd p) {
  for (Index m = 0; m < p.cols(); ++m) {
    const Index joint = data.column_joint[static_cast<std::size_t>(m)];
    if (joint >= 0) p(joint, m) += 1.0;
  }
  return p;
}

MatrixXcd shifted_q(const NoisyLines& data, MatrixXcd q) {
  for (Index r = 0; r < q.rows(); ++r) {
    const Index joint = data.row_joint[static_cast<std::size_t>(r)];
    if (joint >= 0) q(r, joint) -= 1.0;
  }
  return q;
}

/// Whether the errors of a column of the substructures depend on each other, and what an equation makes of them: q F of B's part,
/// and the row of C that is no joint coordinate.
bool has_part_errors(const NoisyLine& line, Index column) {
  return line.part_errors[static_cast<std::size_t>(column)].size() > 0;
}

Eigen::RowVectorXcd part_error(const NoisyLines& data, const NoisyLine& line, const MatrixXcd& q, Index row, Index column,
                               bool with_c) {
  const MatrixXcd& factor = line.part_errors[static_cast<std::size_t>(column)];
  Eigen::RowVectorXcd out = q.row(row) * factor.topRows(q.cols());
  if (with_c && data.row_joint[static_cast<std::size_t>(row)] < 0) out -= factor.row(q.cols() + row);
  return out;
}

/// E|·|² that the errors of B, and those of C that depend on them, make of the equations.
MatrixXd part_variance(const NoisyLines& data, const NoisyLine& line, const MatrixXcd& q) {
  MatrixXd out = q.cwiseAbs2() * line.b_variance;
  for (Index m = 0; m < out.cols(); ++m) {
    if (!has_part_errors(line, m)) continue;
    for (Index r = 0; r < out.rows(); ++r) out(r, m) = part_error(data, line, q, r, m, true).squaredNorm();
  }
  return out;
}

/// NaN of a single FRF must not spread over the sums of its row where the equation does not need it: it does need all of A's row.
LineResidual residual_of(const NoisyLines& data, const NoisyLine& line, const MatrixXcd& z) {
  LineResidual out;
  out.z = z;
  const MatrixXcd za = line.a * z;
  out.p = shifted_p(data, z * line.b);
  out.q = shifted_q(data, za);
  out.r = za * line.b - line.c;
  const MatrixXd variance = line.a_variance * out.p.cwiseAbs2() + part_variance(data, line, out.q) + line.c_variance +
                            line.a_variance * z.cwiseAbs2() * line.b_variance +
                            least_relative_error * least_relative_error * line.c.cwiseAbs2();
  out.weight = MatrixXd::Zero(out.r.rows(), out.r.cols());
  for (Index m = 0; m < out.r.cols(); ++m) {
    for (Index r = 0; r < out.r.rows(); ++r) {
      const bool usable = std::isfinite(variance(r, m)) && variance(r, m) > 0.0 && std::isfinite(std::norm(out.r(r, m)));
      if (usable && data.is_wanted(r, m)) out.weight(r, m) = 1.0 / variance(r, m);
    }
  }
  return out;
}

/// A T_k B: the derivative of r by an unknown.
MatrixXcd derivative(const NoisyLine& line, const std::vector<JointImpedance::Place>& places) {
  MatrixXcd e = MatrixXcd::Zero(line.a.rows(), line.b.cols());
  for (const auto& [row, column, factor] : places) e += factor * line.a.col(row) * line.b.row(column);
  return e;
}

void put(const MatrixXcd& values, const MatrixXd& root_weight, Index column, MatrixXd& rows) {
  const Index half = rows.rows() / 2;
  for (Index i = 0; i < values.size(); ++i) {
    const double weight = root_weight.data()[i];
    rows(i, column) = weight > 0.0 ? weight * values.data()[i].real() : 0.0;
    rows(half + i, column) = weight > 0.0 ? weight * values.data()[i].imag() : 0.0;
  }
}

MatrixXd gram(const MatrixXd& rows) {
  MatrixXd out = MatrixXd::Zero(rows.cols(), rows.cols());
  out.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
  return out.selfadjointView<Eigen::Lower>();
}

/// Σ w Re conj(e_k) e_l over the equations of a line, the last column being r without what the unknowns make of it.
MatrixXd normal_of(const NoisyLine& line, const JointImpedance& joint, const LineResidual& now) {
  const Index p = at(joint.columns().size());
  MatrixXd rows(2 * now.r.size(), p + 1);
  const MatrixXd root = now.weight.cwiseSqrt();
  for (Index k = 0; k < p; ++k) put(derivative(line, joint.places(static_cast<std::size_t>(k))), root, k, rows);
  put(line.a * joint.known() * line.b - line.c, root, p, rows);
  return gram(rows);
}

double or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

MatrixXd known_only(const MatrixXd& values) { return values.unaryExpr(&or_zero); }

/// The part of noise_of() of columns whose errors depend on each other; `q`: of the derivatives, and of what is known.
MatrixXd shared_noise_of(const NoisyLines& data, const NoisyLine& line, const LineResidual& now,
                         const std::vector<MatrixXcd>& q) {
  const Index p = at(q.size()) - 1;
  MatrixXd out = MatrixXd::Zero(p + 1, p + 1);
  for (Index m = 0; m < now.r.cols(); ++m) {
    if (!has_part_errors(line, m)) continue;
    const Index n = line.part_errors[static_cast<std::size_t>(m)].cols();
    MatrixXd rows = MatrixXd::Zero(2 * n * now.r.rows(), p + 1);
    for (Index r = 0; r < now.r.rows(); ++r) {
      if (!(now.weight(r, m) > 0.0)) continue;
      const double root = std::sqrt(now.weight(r, m));
      for (Index k = 0; k <= p; ++k) {
        const Eigen::VectorXcd error = root * part_error(data, line, q[static_cast<std::size_t>(k)], r, m, k == p).transpose();
        rows.col(k).segment(2 * n * r, n) = error.real();
        rows.col(k).segment(2 * n * r + n, n) = error.imag();
      }
    }
    out += gram(rows);
  }
  return out;
}

/// What the errors of the FRFs add to normal_of() on average.
MatrixXd noise_of(const NoisyLines& data, const NoisyLine& line, const JointImpedance& joint, const LineResidual& now) {
  const Index p = at(joint.columns().size()), n = line.b.rows();
  const MatrixXd va = known_only(line.a_variance), vb = known_only(line.b_variance);
  const MatrixXd of_b = (va.transpose() * now.weight).cwiseSqrt();  // [N×L]
  MatrixXd alone = vb;                                              // errors that depend on nothing
  for (Index m = 0; m < alone.cols(); ++m) {
    if (has_part_errors(line, m)) alone.col(m).setZero();
  }
  const MatrixXd of_a = (now.weight * alone.transpose()).cwiseSqrt();  // [M×N]
  const MatrixXd of_both = (va.transpose() * now.weight * vb.transpose()).cwiseSqrt();
  MatrixXd rows_b(2 * of_b.size(), p + 1), rows_a(2 * of_a.size(), p + 1), rows_both(2 * of_both.size(), p + 1);
  std::vector<MatrixXcd> q;
  const auto add = [&](const MatrixXcd& matrix, const MatrixXcd& tb, const MatrixXcd& at_, Index k) {
    q.push_back(at_);
    put(tb, of_b, k, rows_b);
    put(at_, of_a, k, rows_a);
    put(matrix, of_both, k, rows_both);
  };
  for (Index k = 0; k < p; ++k) {
    MatrixXcd matrix = MatrixXcd::Zero(n, n), tb = MatrixXcd::Zero(n, line.b.cols()), a_t = MatrixXcd::Zero(line.a.rows(), n);
    for (const auto& [row, column, factor] : joint.places(static_cast<std::size_t>(k))) {
      matrix(row, column) += factor;
      tb.row(row) += factor * line.b.row(column);
      a_t.col(column) += factor * line.a.col(row);
    }
    add(matrix, tb, a_t, k);
  }
  add(joint.known(), shifted_p(data, joint.known() * line.b), shifted_q(data, line.a * joint.known()), p);
  return gram(rows_b) + gram(rows_a) + gram(rows_both) + shared_noise_of(data, line, now, q);
}

/// Sums of lines over all unknowns of the problem, the right-hand side last.
struct NormalSum {
  std::vector<MatrixXd> by_line;  ///< corrected, [p+1 × p+1] over all columns
  MatrixXd normal, noise;
};

MatrixXd spread(const MatrixXd& local, const std::vector<std::size_t>& columns, Index all) {
  MatrixXd out = MatrixXd::Zero(all + 1, all + 1);
  std::vector<Index> to;
  for (const std::size_t column : columns) to.push_back(at(column));
  to.push_back(all);
  for (Index i = 0; i < local.rows(); ++i) {
    for (Index j = 0; j < local.cols(); ++j) out(to[static_cast<std::size_t>(i)], to[static_cast<std::size_t>(j)]) += local(i, j);
  }
  return out;
}

class WhitenedEquations {
 public:
  WhitenedEquations(const Plan& plan, const NoisyLines& data) : data_(data), unknowns_(at(plan.columns->size())) {
    for (const NoisyLine& line : data.lines) {
      joints_.push_back(joint_at(plan.restriction, *plan.columns, plan.omega0, angular(line.frequency_hz)));
    }
  }

  /// `noise_share`: how much of the variances that are assumed is there.
  NormalSum sum(const std::vector<double>& theta, double noise_share) const {
    NormalSum out{{}, MatrixXd::Zero(unknowns_ + 1, unknowns_ + 1), MatrixXd::Zero(unknowns_ + 1, unknowns_ + 1)};
    each(theta, [&](std::size_t i, const LineResidual& now) {
      const MatrixXd normal = spread(normal_of(data_.lines[i], joints_[i], now), joints_[i].columns(), unknowns_);
      const MatrixXd noise =
          noise_share * spread(noise_of(data_, data_.lines[i], joints_[i], now), joints_[i].columns(), unknowns_);
      out.normal += normal;
      out.noise += noise;
      out.by_line.push_back(normal - noise);
    });
    return out;
  }

  /// The misfit of free parts: A Z B is nothing.
  double free_misfit() const {
    std::vector<double> lines;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].columns().empty()) continue;
      const MatrixXcd none = MatrixXcd::Zero(joints_[i].known().rows(), joints_[i].known().cols());
      const LineResidual now = residual_of(data_, data_.lines[i], none);
      const double used = (now.weight.array() > 0.0).cast<double>().sum();
      if (used > 0.0)
        lines.push_back((now.weight.array() > 0.0).select(now.weight.cwiseProduct(now.r.cwiseAbs2()), 0.0).sum() / used);
    }
    return middle(std::move(lines));
  }

  /// Fills misfits and the number of lines.
  void judge(const std::vector<double>& theta, WhitenedFit& fit) const {
    std::vector<double> lines;
    std::vector<std::vector<double>> rows(data_.rows.size()), columns(data_.columns.size());
    each(theta, [&](std::size_t, const LineResidual& now) {
      const MatrixXd used = (now.weight.array() > 0.0).cast<double>();
      const MatrixXd ratio = (now.weight.array() > 0.0).select(now.weight.cwiseProduct(now.r.cwiseAbs2()), 0.0);
      const auto push = [](double sum, double count, std::vector<double>& to) {
        if (count > 0.0) to.push_back(sum / count);
      };
      push(ratio.sum(), used.sum(), lines);
      for (std::size_t r = 0; r < rows.size(); ++r) push(ratio.row(at(r)).sum(), used.row(at(r)).sum(), rows[r]);
      for (std::size_t c = 0; c < columns.size(); ++c) push(ratio.col(at(c)).sum(), used.col(at(c)).sum(), columns[c]);
    });
    fit.lines = lines.size();
    fit.misfit = middle(std::move(lines));
    fit.row_misfit.clear();
    fit.column_misfit.clear();
    for (auto& row : rows) fit.row_misfit.push_back(middle(std::move(row)));
    for (auto& column : columns) fit.column_misfit.push_back(middle(std::move(column)));
  }

 private:
  static double middle(std::vector<double> values) {
    if (values.empty()) return nan;
    const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, half);
    return *half;
  }

  template <class Work>
  void each(const std::vector<double>& theta, const Work& work) const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      if (joints_[i].columns().empty()) continue;
      const LineResidual now = residual_of(data_, data_.lines[i], joints_[i].at(theta));
      if (now.weight.maxCoeff() > 0.0) work(i, now);
    }
  }

  const NoisyLines& data_;
  Index unknowns_;
  std::vector<JointImpedance> joints_;
};

std::vector<double> solution_of(const MatrixXd& sum) {
  const Index p = sum.rows() - 1;
  const Eigen::VectorXd y = minimise::covariance_of(sum.topLeftCorner(p, p)) * -sum.col(p).head(p);
  return {y.begin(), y.end()};
}

/// H⁻¹ (Σ g_l g_lᵀ) H⁻¹ · L/(L−1), g_l the gradient of line l at theta.
MatrixXd sandwich(const NormalSum& sums, const std::vector<double>& theta) {
  const Index p = at(theta.size());
  Eigen::VectorXd y(p + 1);
  for (Index i = 0; i < p; ++i) y[i] = theta[static_cast<std::size_t>(i)];
  y[p] = 1.0;
  MatrixXd scatter = MatrixXd::Zero(p, p), whole = MatrixXd::Zero(p + 1, p + 1);
  for (const MatrixXd& line : sums.by_line) {
    const Eigen::VectorXd gradient = (line * y).head(p);
    scatter += gradient * gradient.transpose();
    whole += line;
  }
  const MatrixXd inverse = minimise::covariance_of(whole.topLeftCorner(p, p));
  const auto lines = static_cast<double>(sums.by_line.size());
  return inverse * scatter * inverse * (lines / std::max(1.0, lines - 1.0));
}

/// (L−1)/L Σ (θ_l − θ̄)(θ_l − θ̄)ᵀ, θ_l the solution without line l.
MatrixXd leave_one_out(const NormalSum& sums, Index unknowns) {
  const auto lines = at(sums.by_line.size());
  MatrixXd whole = MatrixXd::Zero(unknowns + 1, unknowns + 1), without(unknowns, lines);
  for (const MatrixXd& line : sums.by_line) whole += line;
  for (Index l = 0; l < lines; ++l) {
    const std::vector<double> theta = solution_of(whole - sums.by_line[static_cast<std::size_t>(l)]);
    without.col(l) = Eigen::Map<const Eigen::VectorXd>(theta.data(), unknowns);
  }
  return jackknife_scatter(without);
}

bool finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

/// How many lines take about a second; 0: not even a few.
std::size_t affordable_lines(const Plan& plan) {
  constexpr double flops = 6e8;
  constexpr std::size_t most = 32, least = 6;
  const auto n = static_cast<double>(plan.coordinates.joint.size());
  const double rows = static_cast<double>(plan.coordinates.responses.size()) + n,
               columns = static_cast<double>(plan.coordinates.references.size()) + n;
  const auto unknowns = static_cast<double>(plan.restriction.unknowns.size()), all = static_cast<double>(plan.columns->size());
  const double per_line = 4.0 * rows * columns * (2.0 * unknowns * unknowns + 40.0 * unknowns) + 20.0 * all * all;
  const double lines = flops / per_line;
  return lines < static_cast<double>(least) ? 0 : std::min(most, static_cast<std::size_t>(lines));
}

}  // namespace

std::optional<NoisyLines> lines_to_judge(const Plan& plan) {
  const std::size_t lines = affordable_lines(plan);
  if (lines == 0 || !plan.regenerated.empty() || !plan.scene.couple_first.pairs.empty()) return std::nullopt;
  return read_noisy_lines(plan, lines);
}

bool beyond_any_joint(const Plan& plan, const std::vector<double>& theta) {
  constexpr double far_misfit = 9.0;
  const std::optional<NoisyLines> data = lines_to_judge(plan);
  const std::optional<WhitenedFit> fit = data ? whitened_fit(plan, *data, theta) : std::nullopt;
  return fit && fit->misfit > far_misfit;
}

std::optional<WhitenedFit> whitened_fit(const Plan& plan, const NoisyLines& data, std::vector<double> start) {
  constexpr int iterations = 4;
  constexpr double as_good = 1.1;
  const WhitenedEquations equations(plan, data);
  WhitenedFit best{.theta = std::move(start), .covariance = {}, .jackknife = {}, .row_misfit = {}, .column_misfit = {}};
  equations.judge(best.theta, best);
  if (best.lines == 0 || !finite(best.theta)) return std::nullopt;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const NormalSum sums = equations.sum(best.theta, std::min(1.0, best.misfit));
    const MatrixXd corrected = sums.normal - sums.noise;
    bool moved = false;
    for (const bool with_noise : {false, true}) {
      WhitenedFit next{.theta = solution_of(with_noise ? sums.normal : corrected),
                       .covariance = {},
                       .jackknife = {},
                       .corrected = !with_noise,
                       .row_misfit = {},
                       .column_misfit = {}};
      if (!finite(next.theta)) continue;
      equations.judge(next.theta, next);
      if (!(next.misfit <= (with_noise ? 1.0 / as_good : as_good) * best.misfit)) continue;
      best = std::move(next);
      moved = true;
    }
    if (!moved) break;
  }
  best.free_misfit = equations.free_misfit();
  const NormalSum sums = equations.sum(best.theta, best.corrected ? std::min(1.0, best.misfit) : 0.0);
  best.covariance = sandwich(sums, best.theta);
  if (plan.admissible) best.jackknife = leave_one_out(sums, at(best.theta.size()));
  return best;
}

}  // namespace jointid::ident
