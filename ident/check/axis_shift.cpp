#include "ident/check/axis_shift.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

constexpr Eigen::Index window = 6, powers = 3;  ///< lines, and coefficients of numerator and denominator

/// 1, x, x² in rows.
Eigen::MatrixXd powers_of(const Eigen::VectorXd& x) {
  Eigen::MatrixXd all(x.size(), powers);
  all.col(0).setOnes();
  for (Eigen::Index k = 1; k < powers; ++k) all.col(k) = all.col(k - 1).cwiseProduct(x);
  return all;
}

/// I − V(VᵀWV)⁻¹VᵀW and the solver's pieces are small: the normal equations of three columns by their adjugate.
Eigen::Matrix3d inverse_of(const Eigen::Matrix3d& a) {
  Eigen::Matrix3d inverse;
  const auto minor_of = [&](int r, int c) {
    const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
    return a(r1, c1) * a(r2, c2) - a(r1, c2) * a(r2, c1);
  };
  const double determinant = a(0, 0) * minor_of(0, 0) + a(0, 1) * minor_of(0, 1) + a(0, 2) * minor_of(0, 2);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) inverse(c, r) = minor_of(r, c) / determinant;
  }
  return inverse;
}

/// Eigenvector of the smallest eigenvalue of a Hermitian 3 × 3 matrix, by the real form of twice the size.
Eigen::Vector3cd weakest_direction(const Eigen::Matrix3cd& gram) {
  Eigen::MatrixXd real(6, 6);
  real << gram.real(), -gram.imag(), gram.imag(), gram.real();
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(real);
  Eigen::Vector3cd v;
  for (Eigen::Index k = 0; k < 3; ++k) v(k) = {eigen.vectors(k, 0), eigen.vectors(k + 3, 0)};
  return v.normalized();
}

/// `values`: window × FRFs; `x`: of the lines, 0 at the place wanted.
Eigen::VectorXcd value_at_zero(const Eigen::MatrixXcd& values, const Eigen::VectorXd& x) {
  const Eigen::MatrixXd v = powers_of(x);
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(window, window) - v * inverse_of(v.transpose() * v) * v.transpose();
  const Eigen::RowVectorXd size = (values.cwiseAbs2().colwise().mean().array() + 1e-300).sqrt();
  const Eigen::MatrixXcd scaled = values * size.cwiseInverse().asDiagonal();
  std::array<Eigen::MatrixXcd, powers> left;
  for (Eigen::Index k = 0; k < powers; ++k) left[static_cast<std::size_t>(k)] = rest * (v.col(k).asDiagonal() * scaled);
  Eigen::Matrix3cd gram;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      gram(at(i), at(j)) = left[i].conjugate().cwiseProduct(left[j]).sum();
    }
  }
  const Eigen::Vector3cd denominator = weakest_direction(gram);
  const Eigen::VectorXcd d = v * denominator;
  const Eigen::VectorXd weight = d.cwiseAbs2().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd normal = v.transpose() * weight.asDiagonal() * v;
  const Eigen::RowVectorXd first = inverse_of(normal).row(0) * v.transpose() * weight.asDiagonal();
  return (first * (d.asDiagonal() * values)).transpose() / denominator(0);
}

}  // namespace

std::vector<Eigen::MatrixXcd> shifted_frfs(const CheckedFile& file, const std::vector<std::size_t>& lines, double epsilon) {
  const auto count = at(file.frequency_hz.size());
  const auto rows = at(file.responses.size()), columns = at(file.references.size());
  std::vector<Eigen::MatrixXcd> result;
  for (const std::size_t l : lines) {
    Eigen::MatrixXcd shifted = Eigen::MatrixXcd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
    if (count >= window) {
      const double wanted = file.frequency_hz[l] * (1.0 + epsilon);
      const auto above = std::ranges::lower_bound(file.frequency_hz, wanted) - file.frequency_hz.begin();
      const Eigen::Index first = std::clamp<Eigen::Index>(above - window / 2, 0, count - window);
      const auto hz = [&](Eigen::Index k) { return file.frequency_hz[static_cast<std::size_t>(first + k)]; };
      const double half = 0.5 * (hz(window - 1) * hz(window - 1) - hz(0) * hz(0));
      Eigen::VectorXd x(window);
      Eigen::MatrixXcd values(window, rows * columns);
      for (Eigen::Index k = 0; k < window; ++k) {
        x(k) = (hz(k) * hz(k) - wanted * wanted) / half;
        values.row(k) = file.frfs[static_cast<std::size_t>(first + k)].reshaped().transpose();
      }
      if (values.allFinite()) shifted = value_at_zero(values, x).reshaped(rows, columns);
    }
    result.push_back(std::move(shifted));
  }
  return result;
}

}  // namespace jointid::ident
