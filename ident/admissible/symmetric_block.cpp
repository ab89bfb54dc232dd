#include "ident/admissible/symmetric_block.hpp"

#include <algorithm>
#include <cmath>

#include "dense/eigen.hpp"
#include "minimise/linear/column_scaling.hpp"

namespace jointid::ident {

Eigen::MatrixXd SymmetricBlock::linear_part(const Eigen::VectorXd& theta) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size(), size());
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    for (const auto& [row, column, value] : coefficients[u]) sum(row, column) += theta[unknowns[u]] * value;
  }
  return sum;
}

void SymmetricBlock::add_adjoint(const Eigen::MatrixXd& y, Eigen::VectorXd& to) const {
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    for (const auto& [row, column, value] : coefficients[u]) to[unknowns[u]] += value * y(row, column);
  }
}

SymmetricBlock scaled(SymmetricBlock block, const Eigen::VectorXd& scale) {
  block.constant = scale.asDiagonal() * block.constant * scale.asDiagonal();
  for (auto& entries : block.coefficients) {
    for (auto& [row, column, value] : entries) value *= scale[row] * scale[column];
  }
  return block;
}

Eigen::VectorXd balance(const SymmetricBlock& block, const Eigen::VectorXd& theta) {
  constexpr double cancelled = 1e-6;  // what is left of larger terms by chance is no size
  Eigen::VectorXd largest = block.at(theta).diagonal().cwiseAbs();
  Eigen::VectorXd terms = block.constant.diagonal().cwiseAbs(), coefficient = Eigen::VectorXd::Zero(block.size());
  for (std::size_t u = 0; u < block.unknowns.size(); ++u) {
    for (const auto& [row, column, value] : block.coefficients[u]) {
      if (row != column) continue;
      coefficient[row] = std::max(coefficient[row], std::abs(value));
      terms[row] += std::abs(theta[block.unknowns[u]] * value);
    }
  }
  for (Eigen::Index i = 0; i < largest.size(); ++i) {
    largest[i] = std::max(largest[i], cancelled * terms[i]);
    largest[i] = minimise::power_of_two_scale(std::sqrt(largest[i] > 0.0 ? largest[i] : coefficient[i]));
  }
  return largest;
}

double least_eigenvalue(const Eigen::MatrixXd& symmetric) {
  if (symmetric.rows() == 1) return symmetric(0, 0);
  return dense::symmetric_eigenvalues(symmetric)[0];
}

}  // namespace jointid::ident
