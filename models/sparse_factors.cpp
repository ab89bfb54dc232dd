#include "models/sparse_factors.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

#include "base/module.hpp"

namespace jointid::models {
namespace {

constexpr Module cholmod_module{"cholmod", "models of many coordinates", "libsuitesparse-dev"};
constexpr Eigen::Index least_supernodal = 1000;  ///< rows; smaller matrices take milliseconds either way

class EigenFactors final : public PositiveFactors {
 public:
  bool factorize(const Eigen::SparseMatrix<double>& matrix) override {
    ldlt_.compute(matrix);
    return ldlt_.info() == Eigen::Success && (ldlt_.vectorD().array() > 0.0).all();
  }
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) override { return ldlt_.solve(b); }
  bool is_supernodal() const override { return false; }

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> ldlt_;
};

}  // namespace

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

bool has_cholmod() { return is_there(cholmod_module); }

std::unique_ptr<PositiveFactors> positive_factors(Eigen::Index rows) {
  if (rows >= least_supernodal && has_cholmod()) return interface_of<CholmodModule>(cholmod_module).supernodal();
  return std::make_unique<EigenFactors>();
}

}  // namespace jointid::models
