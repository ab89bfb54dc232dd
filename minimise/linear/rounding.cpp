#include "minimise/linear/rounding.hpp"

#include <cmath>
#include <limits>

namespace jointid::minimise {

double growth(std::size_t rows) {
  return std::numeric_limits<double>::epsilon() * (4.0 + std::sqrt(static_cast<double>(rows) / 128.0));
}

void bound_rounding(const SystemNorms& norms, Reduction reduction, std::size_t rows, LinearSolution& out) {
  const auto n = norms.columns.size();
  const Eigen::Map<const Eigen::VectorXd> y(out.y.data(), n);
  const double size = norms.columns.dot(y.cwiseAbs()) + norms.right;
  const double condition = norms.inverse_rows.dot(norms.columns);
  const double moved = reduction == Reduction::normal ? condition * size : size + out.residual_norm * condition;
  out.inverse_norms.assign(norms.inverse_rows.begin(), norms.inverse_rows.end());
  out.rounding.clear();
  for (const double inverse : norms.inverse_rows) out.rounding.push_back(growth(rows) * inverse * moved);
}

}  // namespace jointid::minimise
