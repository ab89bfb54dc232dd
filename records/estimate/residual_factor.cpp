#include "records/estimate/residual_factor.hpp"

#include "base/statistics.hpp"

namespace jointid::records {

Eigen::MatrixXcd residual_factor(Eigen::MatrixXcd errors, Eigen::MatrixXcd directions) {
  const Eigen::Index count = errors.cols(), forces = directions.rows();
  for (Eigen::Index j = 0; j < forces; ++j) {
    // Q = I − 2 v vᴴ/|v|² takes w = dᴴ to a multiple of the axis e_j; v = w + e^(i arg w_j) |w| e_j does not cancel.
    const Eigen::Index left = count - j;
    Eigen::VectorXcd v = directions.row(j).tail(left).adjoint();
    const double size = std::abs(v[0]), norm = v.norm();
    v[0] += size > 0.0 ? v[0] * (norm / size) : norm;
    const double factor = 2.0 / v.squaredNorm();
    const auto turn = [&](auto&& rows) { rows -= (rows * v * factor).eval() * v.adjoint(); };
    turn(errors.rightCols(left));
    turn(directions.rightCols(left));
  }
  Eigen::MatrixXcd out = errors.rightCols(count - forces);
  for (Eigen::Index r = 0; r < out.rows(); ++r) {
    if (!out.row(r).allFinite()) out.row(r).setConstant({nan, nan});
  }
  return out;
}

}  // namespace jointid::records
