#include <Eigen/SVD>

#include "dense/svd_options.hpp"

namespace jointid::dense {

ComplexSvd svd(const Eigen::Ref<const Eigen::MatrixXcd>& a, Vectors u, Vectors v) {
  return svd_parts<Eigen::MatrixXcd>(Eigen::BDCSVD<Eigen::MatrixXcd>(a, svd_options(u, v)), u, v);
}

ComplexSvd jacobi_svd(const Eigen::Ref<const Eigen::MatrixXcd>& a, Vectors u, Vectors v) {
  return svd_parts<Eigen::MatrixXcd>(Eigen::JacobiSVD<Eigen::MatrixXcd>(a, svd_options(u, v)), u, v);
}

}  // namespace jointid::dense
