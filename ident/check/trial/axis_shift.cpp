#include "ident/check/trial/axis_shift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

constexpr Eigen::Index window = 6, powers = 3;    ///< lines, and coefficients of numerator and denominator
constexpr std::size_t most_of_denominator = 250;  ///< FRFs that tell it; they share it

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

/// The denominator's coefficients: that of `values` (window × FRFs), scaled by their sizes, which leave least.
Eigen::Vector3cd common_denominator(const Eigen::MatrixXcd& values, const Eigen::MatrixXd& v) {
  const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(window, window) - v * inverse_of(v.transpose() * v) * v.transpose();
  const Eigen::RowVectorXd size = (values.cwiseAbs2().colwise().mean().array() + 1e-300).sqrt();
  const Eigen::MatrixXcd scaled = values * size.cwiseInverse().asDiagonal();
  const Eigen::MatrixXcd left = rest.cwiseProduct(scaled.conjugate() * scaled.transpose());  // of values a and b of the window
  const Eigen::Matrix3cd gram = v.transpose() * left * v;
  return weakest_direction(gram);
}

/// Factors of the values in the window, whose sum of products is the value at x = 0 of the fitted numerator over the denominator.
Eigen::VectorXcd factors_at_zero(const Eigen::Vector3cd& denominator, const Eigen::MatrixXd& v) {
  const Eigen::VectorXcd d = v * denominator;
  const Eigen::VectorXd weight = d.cwiseAbs2().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd normal = v.transpose() * weight.asDiagonal() * v;
  const Eigen::Vector3d row = inverse_of(normal).row(0).transpose();
  const Eigen::VectorXd first = (v * row).cwiseProduct(weight);
  return first.cast<std::complex<double>>().cwiseProduct(d) / denominator(0);
}

}  // namespace

std::vector<Eigen::MatrixXcd> shifted_frfs(const CheckedFile& file, const std::vector<std::size_t>& lines, double epsilon) {
  const auto count = at(file.frequency_hz.size());
  const auto rows = at(file.responses.size()), columns = at(file.references.size());
  const auto of_denominator = spread_lines(file.responses.size() * file.references.size(), most_of_denominator);
  std::vector<Eigen::MatrixXcd> result;
  for (const std::size_t l : lines) {
    Eigen::MatrixXcd shifted = Eigen::MatrixXcd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
    if (count >= window) {
      const double wanted = file.frequency_hz[l] * (1.0 + epsilon);
      const auto above = std::ranges::lower_bound(file.frequency_hz, wanted) - file.frequency_hz.begin();
      const Eigen::Index first = std::clamp<Eigen::Index>(above - window / 2, 0, count - window);
      const auto hz = [&](Eigen::Index k) { return file.frequency_hz[static_cast<std::size_t>(first + k)]; };
      const auto frfs = [&](Eigen::Index k) -> const Eigen::MatrixXcd& { return file.frfs[static_cast<std::size_t>(first + k)]; };
      const double half = 0.5 * (hz(window - 1) * hz(window - 1) - hz(0) * hz(0));
      Eigen::VectorXd x(window);
      Eigen::MatrixXcd some(window, at(of_denominator.size()));
      for (Eigen::Index k = 0; k < window; ++k) {
        x(k) = (hz(k) * hz(k) - wanted * wanted) / half;
        for (Eigen::Index i = 0; i < some.cols(); ++i) {
          some(k, i) = frfs(k).reshaped()(at(of_denominator[static_cast<std::size_t>(i)]));
        }
      }
      if (some.allFinite()) {
        const Eigen::MatrixXd v = powers_of(x);
        const Eigen::VectorXcd factors = factors_at_zero(common_denominator(some, v), v);
        shifted = factors(0) * frfs(0);
        for (Eigen::Index k = 1; k < window; ++k) shifted += factors(k) * frfs(k);
      }
    }
    result.push_back(std::move(shifted));
  }
  return result;
}

}  // namespace jointid::ident
