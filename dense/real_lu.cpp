#include "dense/real_lu.hpp"

#include <Eigen/LU>

namespace jointid::dense {

struct RealLu::Factors {
  Eigen::PartialPivLU<Eigen::MatrixXd> lu;
};

RealLu::RealLu(const Eigen::Ref<const Eigen::MatrixXd>& a)
    : factors_(std::make_shared<const Factors>(Factors{Eigen::PartialPivLU<Eigen::MatrixXd>(a)})) {}

Eigen::MatrixXd RealLu::solve(const Eigen::Ref<const Eigen::MatrixXd>& b) const { return factors_->lu.solve(b); }

}  // namespace jointid::dense
