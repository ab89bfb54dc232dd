#include <Eigen/SVD>

#include "dense/svd_options.hpp"

namespace jointid::dense {

RealSvd svd(const Eigen::Ref<const Eigen::MatrixXd>& a, Vectors u, Vectors v) {
  return svd_parts<Eigen::MatrixXd>(Eigen::BDCSVD<Eigen::MatrixXd>(a, svd_options(u, v)), u, v);
}

RealSvd jacobi_svd(const Eigen::Ref<const Eigen::MatrixXd>& a, Vectors u, Vectors v) {
  return svd_parts<Eigen::MatrixXd>(Eigen::JacobiSVD<Eigen::MatrixXd>(a, svd_options(u, v)), u, v);
}

}  // namespace jointid::dense
