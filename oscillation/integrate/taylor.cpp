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

TaylorSeries::TaylorSeries(const ContactSystem& system) : system_(system) {
  for (const Mode mode : {Mode::backward, Mode::stick, Mode::forward}) {
    const MatrixXd& a = system.drift[place(mode)];
    for (Index i = 0; i < a.rows(); ++i) {
      for (Index j = 0; j < a.cols(); ++j) {
        if (a(i, j) != 0.0) entries_[place(mode)].push_back({i, j, a(i, j)});
      }
    }
  }
  for (Index i = 0; i < system.push.size(); ++i) {
    if (system.push(i) != 0.0) pushed_.push_back(i);
  }
}

void TaylorSeries::expand(Mode mode, const VectorXd& z, Piece& piece) {
  mode_ = mode;
  falls_ = mode != Mode::stick && system_.is_falling();
  piece.mode = mode;
  piece.coefficients.setZero(z.size(), order + 1);
  piece.coefficients.col(0) = z;
  if (falls_) {
    rate_ = *system_.friction.decay * sign(mode);
    drop_ = sign(mode) * (system_.friction.statical - system_.friction.kinetic);
  }
  double* const base = piece.coefficients.data();
  for (Index k = 0; k < order; ++k) {
    const double* const from = base + k * z.size();
    double* const to = base + (k + 1) * z.size();
    for (const Entry& entry : entries_[place(mode)]) to[entry.row] += entry.value * from[entry.column];
    if (falls_) {
      const auto now = static_cast<std::size_t>(k);
      velocity_[now] = system_.relative[place(mode)].dot(piece.coefficients.col(k));
      load_[now] = system_.normal.dot(piece.coefficients.col(k));
      if (k == 0) decay_[0] = std::exp(-rate_ * velocity_[0]);
      double e = 0.0;
      for (std::size_t j = 1; j <= now; ++j) e += static_cast<double>(j) * velocity_[j] * decay_[now - j];
      if (k > 0) decay_[now] = -rate_ * e / static_cast<double>(k);
      product_[now] = 0.0;
      for (std::size_t j = 0; j <= now; ++j) product_[now] += load_[j] * decay_[now - j];
      for (const Index row : pushed_) to[row] += drop_ * product_[now] * system_.push(row);
    }
    for (Index i = 0; i < z.size(); ++i) to[i] /= static_cast<double>(k + 1);
  }
  const Index motion = 2 * system_.degrees();
  const double size =
      std::max(z.head(motion).cwiseAbs().maxCoeff(), piece.coefficients.col(1).head(motion).cwiseAbs().maxCoeff() * 1e-3);
  piece.length = std::numeric_limits<double>::infinity();
  for (Index k = order - 1; k <= order; ++k) {
    const double last = piece.coefficients.col(k).head(motion).cwiseAbs().maxCoeff();
    if (last > 0.0) piece.length = std::min(piece.length, std::pow(1e-17 * size / last, 1.0 / static_cast<double>(k)));
  }
}

void TaylorSeries::expand_tangents(const MatrixXd& tangents, std::vector<MatrixXd>& coefficients) {
  coefficients.resize(order + 1);
  coefficients[0] = tangents;
  MatrixXd velocity(order + 1, tangents.cols()), load(order + 1, tangents.cols());
  for (Index k = 0; k < order; ++k) {
    const MatrixXd& from = coefficients[static_cast<std::size_t>(k)];
    MatrixXd& to = coefficients[static_cast<std::size_t>(k) + 1];
    to.setZero(tangents.rows(), tangents.cols());
    for (Index c = 0; c < tangents.cols(); ++c) {
      const double* const in = from.col(c).data();
      double* const out = to.col(c).data();
      for (const Entry& entry : entries_[place(mode_)]) out[entry.row] += entry.value * in[entry.column];
    }
    if (falls_) {
      velocity.row(k) = system_.relative[place(mode_)].transpose() * from;
      load.row(k) = system_.normal.transpose() * from;
      Eigen::RowVectorXd change = Eigen::RowVectorXd::Zero(tangents.cols());
      for (Index j = 0; j <= k; ++j) {
        const auto left = static_cast<std::size_t>(k - j);
        change += decay_[left] * load.row(j) - rate_ * product_[left] * velocity.row(j);
      }
      for (const Index row : pushed_) to.row(row) += drop_ * system_.push(row) * change;
    }
    to /= static_cast<double>(k + 1);
  }
}

MatrixXd tangents_at(const std::vector<MatrixXd>& coefficients, double tau) {
  MatrixXd sum = coefficients.back();
  for (std::size_t k = coefficients.size() - 1; k-- > 0;) sum = coefficients[k] + tau * sum;
  return sum;
}

}  // namespace jointid::oscillation
