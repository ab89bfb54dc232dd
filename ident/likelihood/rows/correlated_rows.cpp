#include "ident/likelihood/rows/correlated_rows.hpp"

#include "base/eigen.hpp"
#include "dense/blas.hpp"
#include "dense/cholesky.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXcd;

MatrixXcd whitened(const MatrixXcd& factor, const MatrixXcd& transposed) {
  MatrixXcd z = transposed.transpose();
  dense::solve_lower(factor, z);
  return z;
}

}  // namespace

void CorrelatedRows::reset(const minimise::Correlation& correlation, std::size_t columns) {
  correlation_ = &correlation;
  groups_.resize(correlation.groups().size());
  for (std::size_t g = 0; g < groups_.size(); ++g) groups_[g].setZero(at(columns), at(correlation.groups()[g].elements.size()));
}

void CorrelatedRows::add_to(Eigen::Ref<Eigen::MatrixXd> normal) const {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    const auto& [elements, factor, of_parts] = correlation_->groups()[g];
    const bool circular = of_parts.size() == 0;
    const MatrixXcd z = circular ? whitened(factor, groups_[g]) : MatrixXcd(groups_[g].transpose());
    Eigen::MatrixXd parts(2 * z.rows(), z.cols());
    parts << z.real(), z.imag();
    if (!circular) dense::solve_lower(of_parts, parts);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(parts.transpose());
  }
}

void CorrelatedRows::add_to(MatrixXcd& normal) const {
  for (std::size_t g = 0; g < groups_.size(); ++g) {
    dense::add_square(whitened(correlation_->groups()[g].factor, groups_[g]).adjoint(), normal);
  }
}

}  // namespace jointid::ident
