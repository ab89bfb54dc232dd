#include "models/sparse_factors.hpp"

#include <Eigen/SparseLU>

namespace jointid::models {

struct SparseFactors::Lu {
  Eigen::SparseLU<Eigen::SparseMatrix<Complex>> factors;
  bool ordered = false;
};

SparseFactors::SparseFactors() : lu_(std::make_unique<Lu>()) { lu_->factors.isSymmetric(true); }

SparseFactors::~SparseFactors() = default;

bool SparseFactors::factorize(const Eigen::SparseMatrix<Complex>& z) {
  if (!lu_->ordered) lu_->factors.analyzePattern(z);
  lu_->ordered = true;
  lu_->factors.factorize(z);
  return lu_->factors.info() == Eigen::Success;
}

Eigen::MatrixXcd SparseFactors::solve(const Eigen::MatrixXcd& b) const { return lu_->factors.solve(b); }

}  // namespace jointid::models
