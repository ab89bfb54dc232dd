#include "modalfit/model/shape_covariance.hpp"

#include <algorithm>

#include "base/eigen.hpp"

namespace jointid::modalfit {

Core::Core(const std::vector<bool>& is_core) : count(static_cast<std::size_t>(std::ranges::count(is_core, true))) {
  std::size_t in = 0, out = count;
  for (const bool each : is_core) place.push_back(each ? in++ : out++);
}

ShapeCovariance::ShapeCovariance(Core core, Eigen::MatrixXcd with_core, Eigen::MatrixXcd slope, Eigen::VectorXd own)
    : core_(std::move(core)), with_core_(std::move(with_core)), slope_(std::move(slope)), own_(std::move(own)) {}

std::complex<double> ShapeCovariance::between(std::size_t a, std::size_t b) const {
  const auto row = at(core_.place[a]);
  if (core_.has(b)) return with_core_(row, at(core_.place[b]));
  const auto rest = at(core_.place[b] - core_.count);
  const std::complex<double> shared = slope_.row(rest).conjugate().cwiseProduct(with_core_.row(row)).sum();
  return a == b ? shared + own_(rest) : shared;
}

void ShapeCovariance::multiply(double factor) {
  with_core_ *= factor;
  own_ *= factor;
}

}  // namespace jointid::modalfit
