#include "impedance/line/error_columns.hpp"

#include <algorithm>

namespace jointid::impedance {

Eigen::MatrixXcd errors_of(const Eigen::MatrixXcd& jacobian, const ErrorColumns& columns) {
  std::vector<bool> is_used(static_cast<std::size_t>(jacobian.cols()));
  for (Eigen::Index e = 0; e < jacobian.cols(); ++e)
    is_used[static_cast<std::size_t>(e)] = (jacobian.col(e).array() != 0.0).any();
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (std::ranges::any_of(columns[k], [&](const auto& one) { return is_used[static_cast<std::size_t>(one.first)]; }))
      kept.push_back(k);
  }
  Eigen::MatrixXcd out = Eigen::MatrixXcd::Zero(jacobian.rows(), static_cast<Eigen::Index>(kept.size()));
  for (std::size_t k = 0; k < kept.size(); ++k) {
    for (const auto& [frf, factor] : columns[kept[k]]) {
      if (is_used[static_cast<std::size_t>(frf)]) out.col(static_cast<Eigen::Index>(k)) += factor * jacobian.col(frf);
    }
  }
  return out;
}

}  // namespace jointid::impedance
