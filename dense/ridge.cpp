#include "dense/ridge.hpp"

#include <algorithm>
#include <utility>

#include "dense/cholesky.hpp"
#include "dense/gram.hpp"
#include "dense/qr.hpp"

namespace jointid::dense {

using Eigen::MatrixXd;

Ridge::Ridge(MatrixXd b) : b_(std::move(b)) {
  const Eigen::Index size = std::min(b_.rows(), b_.cols());
  lower_ = MatrixXd::Identity(size, size);
  const auto add = [&](const MatrixXd& of) {
    add_gram(of.data(), static_cast<std::size_t>(of.rows()), static_cast<std::size_t>(size), static_cast<std::size_t>(of.rows()),
             lower_.data());
  };
  if (b_.rows() < b_.cols()) {
    add(b_.transpose());
  } else {
    add(b_);
  }
  cholesky_in_place(lower_);  // I + a square is positive definite
}

/// Of a wide B by (I + BBᵀ)⁻¹: what a step from zero leaves of gradients of the size ‖B‖‖R‖ has lost the digits of a small U.
MatrixXd Ridge::first(const Eigen::Ref<const MatrixXd>& r) const {
  if (b_.rows() >= b_.cols()) return step(r, MatrixXd::Zero(b_.cols(), r.cols()));
  MatrixXd solved = r;
  solve_lower(lower_, solved);
  solve_lower_transposed(lower_, solved);
  return -(b_.transpose() * solved);
}

/// Of the normal equations (I + BᵀB)δ = −(Bᵀ(R + BU) + U).
MatrixXd Ridge::step(const Eigen::Ref<const MatrixXd>& r, const MatrixXd& u) const {
  MatrixXd gradient = -(b_.transpose() * (r + b_ * u) + u);
  if (b_.rows() >= b_.cols()) {
    solve_lower(lower_, gradient);
    solve_lower_transposed(lower_, gradient);
    return gradient;
  }
  MatrixXd solved = b_ * gradient;  // (I + BᵀB)⁻¹ = I − Bᵀ(I + BBᵀ)⁻¹B
  solve_lower(lower_, solved);
  solve_lower_transposed(lower_, solved);
  return gradient - b_.transpose() * solved;
}

MatrixXd Ridge::best(const Eigen::Ref<const MatrixXd>& r) const {
  if (b_.cols() == 0) return MatrixXd::Zero(0, r.cols());
  const MatrixXd u = first(r);
  return u + step(r, u);
}

MatrixXd Ridge::left(const Eigen::Ref<const MatrixXd>& r) const {
  const MatrixXd u = best(r);
  MatrixXd all(r.rows() + u.rows(), r.cols());
  all << r + b_ * u, u;
  return all.rows() > all.cols() ? triangle_of(all) : all;
}

}  // namespace jointid::dense
