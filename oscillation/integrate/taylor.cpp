#include "oscillation/integrate/taylor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jointid::oscillation {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd Piece::at(double tau) const {
  VectorXd z = coefficients.col(coefficients.cols() - 1);
  for (Index k = coefficients.cols() - 1; k-- > 0;) z = coefficients.col(k) + tau * z;
  return z;
}

TaylorSeries::Sparse::Sparse(const MatrixXd& a) {
  for (Index i = 0; i < a.rows(); ++i) {
    row_start.push_back(static_cast<std::int32_t>(value.size()));
    for (Index j = 0; j < a.cols(); ++j) {
      if (a(i, j) == 0.0) continue;
      column.push_back(static_cast<std::int32_t>(j));
      value.push_back(a(i, j));
    }
  }
  row_start.push_back(static_cast<std::int32_t>(value.size()));
}

TaylorSeries::TaylorSeries(const ContactSystem& system) : system_(system) {
  for (const Mode mode : {Mode::backward, Mode::stick, Mode::forward}) {
    drift_[place(mode)] = Sparse(system.drift[place(mode)]);
    MatrixXd forms(2, system.size());
    forms << system.relative[place(mode)].transpose(), system.normal.transpose();
    forms_[place(mode)] = Sparse(forms);
  }
  for (Index i = 0; i < system.push.size(); ++i) {
    if (system.push(i) != 0.0) pushed_.push_back(i);
  }
}

void TaylorSeries::Sparse::multiply(const double* in, double* out, double factor) const {
  const std::int32_t* const columns = column.data();
  const double* const values = value.data();
  for (std::size_t i = 0; i + 1 < row_start.size(); ++i) {
    double sum = 0.0;
    for (std::int32_t e = row_start[i]; e < row_start[i + 1]; ++e) sum += values[e] * in[columns[e]];
    out[i] = factor * sum;
  }
}

/// Over which the last two terms stay below 1e-17 of the motion, and of the drive's sine and cosine: a body that sticks may not
/// move at all while its drive does.
double TaylorSeries::trusted_length(const MatrixXd& c, Index motion) {
  const double size = std::max(c.col(0).head(motion).cwiseAbs().maxCoeff(), c.col(1).head(motion).cwiseAbs().maxCoeff() * 1e-3);
  double length = std::numeric_limits<double>::infinity();
  for (Index k = order - 1; k <= order; ++k) {
    const double power = 1.0 / static_cast<double>(k);
    const double moved = c.col(k).head(motion).cwiseAbs().maxCoeff(),
                 driven = c.col(k).segment(motion + 1, 2).cwiseAbs().maxCoeff();
    if (moved > 0.0) length = std::min(length, std::pow(1e-17 * size / moved, power));
    if (driven > 0.0) length = std::min(length, std::pow(1e-17 / driven, power));
  }
  return length;
}

/// α|V_r| changes by 12 at most: the terms of e^{−αV_r} fall from the 12th on, so that the last two tell of those left out. Over
/// longer steps a force that is nothing at the start would rise to all of it behind them.
void TaylorSeries::limit_fall(double& length) const {
  constexpr double most = 12.0;
  double change = 0.0, power = length;
  for (std::size_t k = 1; k < order; ++k, power *= length)
    change += std::abs(rate_ * rising_[k]) / static_cast<double>(k) * power;
  if (change > most) length *= most / change;  // the sum shrinks at least as fast
}

void TaylorSeries::expand(Mode mode, const VectorXd& z, Piece& piece) {
  mode_ = mode;
  falls_ = mode != Mode::stick && system_.is_falling();
  piece.mode = mode;
  piece.coefficients.resize(z.size(), order + 1);
  piece.coefficients.col(0) = z;
  if (falls_) {
    rate_ = *system_.friction.decay * sign(mode);
    drop_ = sign(mode) * (system_.statical(mode) - system_.kinetic(mode));
  }
  double* const base = piece.coefficients.data();
  for (Index k = 0; k < order; ++k) {
    const double* const from = base + k * z.size();
    double* const to = base + (k + 1) * z.size();
    const double factor = 1.0 / static_cast<double>(k + 1);
    drift_[place(mode)].multiply(from, to, factor);
    if (falls_) {
      const auto now = static_cast<std::size_t>(k);
      const Eigen::Map<const VectorXd> rising(rising_.data(), k + 1), load(load_.data(), k + 1),
          decay(reversed_.data() + order - k, k + 1);
      std::array<double, 2> of_state{};
      forms_[place(mode)].multiply(from, of_state.data(), 1.0);
      rising_[now] = static_cast<double>(k) * of_state[0];
      load_[now] = of_state[1];
      reversed_[order - now] = 0.0;  // E_k does not count for itself
      decay_[now] = k == 0 ? std::exp(-rate_ * of_state[0]) : -rate_ * rising.dot(decay) / static_cast<double>(k);
      reversed_[order - now] = decay_[now];
      product_[now] = load.dot(decay);
      for (const Index row : pushed_) to[row] += factor * drop_ * product_[now] * system_.push(row);
    }
  }
  piece.length = trusted_length(piece.coefficients, 2 * system_.degrees());
  if (falls_ && std::isfinite(piece.length)) limit_fall(piece.length);
}

void TaylorSeries::expand_tangents(const MatrixXd& tangents, std::vector<MatrixXd>& coefficients) {
  coefficients.resize(order + 1);
  coefficients[0] = tangents;
  MatrixXd velocity(order + 1, tangents.cols()), load(order + 1, tangents.cols());
  for (Index k = 0; k < order; ++k) {
    const MatrixXd& from = coefficients[static_cast<std::size_t>(k)];
    MatrixXd& to = coefficients[static_cast<std::size_t>(k) + 1];
    const double factor = 1.0 / static_cast<double>(k + 1);
    to.resize(tangents.rows(), tangents.cols());
    for (Index c = 0; c < tangents.cols(); ++c) drift_[place(mode_)].multiply(from.col(c).data(), to.col(c).data(), factor);
    if (falls_) {
      velocity.row(k) = system_.relative[place(mode_)].transpose() * from;
      load.row(k) = system_.normal.transpose() * from;
      Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(tangents.cols());
      for (Index j = 0; j <= k; ++j) {
        const auto left = static_cast<std::size_t>(k - j);
        change += decay_[left] * load.row(j) - rate_ * product_[left] * velocity.row(j);
      }
      for (const Index row : pushed_) to.row(row) += factor * drop_ * system_.push(row) * change;
    }
  }
}

MatrixXd tangents_at(const std::vector<MatrixXd>& coefficients, double tau) {
  MatrixXd sum = coefficients.back();
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) sum = coefficients[k] + tau * sum;
  return sum;
}

}  // namespace jointid::oscillation
