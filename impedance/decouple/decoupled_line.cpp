#include "impedance/decouple/decoupled_line.hpp"

#include <algorithm>

#include "dense/lu.hpp"
#include "dense/svd.hpp"

namespace jointid::impedance {
namespace {

using Index = Eigen::Index;
using Places = std::vector<Index>;

Eigen::MatrixXcd part_of(const Eigen::MatrixXcd& from, const Places& rows, const Places& columns) {
  Eigen::MatrixXcd out(static_cast<Index>(rows.size()), static_cast<Index>(columns.size()));
  for (Index r = 0; r < out.rows(); ++r) {
    for (Index c = 0; c < out.cols(); ++c)
      out(r, c) = from(rows[static_cast<std::size_t>(r)], columns[static_cast<std::size_t>(c)]);
  }
  return out;
}

/// M E_R over `size` coordinates.
Eigen::MatrixXcd spread_columns(const Eigen::MatrixXcd& m, const Places& places, Index size) {
  Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(m.rows(), size);
  for (std::size_t i = 0; i < places.size(); ++i) out.col(places[i]) += m.col(static_cast<Index>(i));
  return out;
}

/// Adds δH of every error of a system, L δH R, column by column of `vec H_B`.
void add_errors(const MeasuredSystem& system, const Eigen::MatrixXcd& l, const Eigen::MatrixXcd& r, double sign,
                Eigen::MatrixXcd& jacobian, Index first) {
  for (std::size_t e = 0; e < system.frfs.size(); ++e) {
    const auto [p, q] = system.frfs[e];
    Eigen::MatrixXcd change = l.col(p) * r.row(q);
    if (p != q) change += l.col(q) * r.row(p);
    jacobian.col(first + static_cast<Index>(e)) = sign * change.reshaped();
  }
}

/// Variances and covariances of the columns of a matrix of which `errors` has δ vec by independent real errors.
void set_errors(const Eigen::MatrixXcd& errors, DecoupledLine& out) {
  const Index size = out.h.rows();
  const Eigen::VectorXd re = errors.real().rowwise().squaredNorm(), im = errors.imag().rowwise().squaredNorm();
  out.variance_re = re.reshaped(size, out.h.cols());
  out.variance_im = im.reshaped(size, out.h.cols());
  for (Index c = 0; c < out.h.cols(); ++c) {
    const Eigen::MatrixXcd rows = errors.middleRows(c * size, size);
    out.covariance.emplace_back(rows * rows.adjoint());
  }
}

}  // namespace

DecoupledLine decouple(const MeasuredSystem& whole, const MeasuredSystem& a, const DecoupleAt& at) {
  const Eigen::MatrixXcd difference = part_of(whole.h, at.v, at.e) - part_of(a.h, at.v_of_a, at.e_of_a);
  const dense::ComplexSvd svd = dense::jacobi_svd(difference, dense::Vectors::thin, dense::Vectors::thin);
  const Index kept = at.kept == 0 ? svd.sigma.size() : std::min(svd.sigma.size(), static_cast<Index>(at.kept));
  const Eigen::MatrixXcd inverse =
      svd.v.leftCols(kept) * svd.sigma.head(kept).cwiseInverse().asDiagonal() * svd.u.leftCols(kept).adjoint();
  DecoupledLine out;
  out.singular_values = svd.sigma;
  const Eigen::MatrixXcd left = part_of(whole.h, at.u, at.e) * inverse, right = inverse * part_of(whole.h, at.v, at.u);
  out.h = part_of(whole.h, at.u, at.u) - left * part_of(whole.h, at.v, at.u);
  const Index n = whole.h.rows(), n_of_a = a.h.rows(), u = static_cast<Index>(at.u.size());
  const Eigen::MatrixXcd identity = Eigen::MatrixXcd::Identity(u, u);
  const Eigen::MatrixXcd l = spread_columns(identity, at.u, n) - spread_columns(left, at.v, n);
  const Eigen::MatrixXcd r = (spread_columns(identity, at.u, n) - spread_columns(right.transpose(), at.e, n)).transpose();
  Eigen::MatrixXcd of_whole(u * u, static_cast<Index>(whole.frfs.size())), of_a(u * u, static_cast<Index>(a.frfs.size()));
  add_errors(whole, l, r, 1.0, of_whole, 0);
  add_errors(a, spread_columns(left, at.v_of_a, n_of_a), spread_columns(right.transpose(), at.e_of_a, n_of_a).transpose(), -1.0,
             of_a, 0);
  const Eigen::MatrixXcd by_whole = errors_of(of_whole, whole.errors), by_a = errors_of(of_a, a.errors);
  Eigen::MatrixXcd errors(u * u, by_whole.cols() + by_a.cols());
  errors << by_whole, by_a;
  set_errors(errors, out);
  return out;
}

DecoupledLine receptance_of(const Eigen::MatrixXcd& z, const Eigen::MatrixXd& covariance) {
  const Index size = z.rows(), count = size * (size + 1) / 2;
  DecoupledLine out;
  const Eigen::MatrixXcd y = dense::inverse(z);
  out.h = 0.5 * (y + y.transpose());
  Eigen::MatrixXcd jacobian(size * size, count);
  Index t = 0;
  for (Index r = 0; r < size; ++r) {
    for (Index c = r; c < size; ++c) {
      Eigen::MatrixXcd change = -out.h.col(r) * out.h.row(c);
      if (r != c) change -= out.h.col(c) * out.h.row(r);
      jacobian.col(t++) = change.reshaped();
    }
  }
  // The root of the covariance of the real unknowns: δz = root · u.
  const dense::RealSvd root = dense::svd(covariance, dense::Vectors::thin, dense::Vectors::none);
  const Eigen::MatrixXd factor = root.u * root.sigma.cwiseSqrt().asDiagonal();
  const Eigen::MatrixXcd errors = jacobian * (factor.topRows(count) + Complex(0.0, 1.0) * factor.bottomRows(count));
  set_errors(errors, out);
  return out;
}

}  // namespace jointid::impedance
