#include <Eigen/SparseCholesky>

#include "base/eigen.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::minimise {
namespace {

class Ldlt final : public SparseFactor {
 public:
  bool factorize(const SparseSymmetric& matrix) override {
    const Matrix view = Eigen::Map<const Matrix>(at(matrix.size()), at(matrix.size()), at(matrix.value.size()), matrix.start.data(),
                                                 matrix.row.data(), matrix.value.data());
    if (matrix.start != start_ || matrix.row != row_) {
      start_ = matrix.start;
      row_ = matrix.row;
      factor_.analyzePattern(view);
    }
    factor_.factorize(view);
    return factor_.info() == Eigen::Success && (factor_.vectorD().array() > 0.0).all();
  }

  std::vector<double> solve(const std::vector<double>& right) override {
    const Eigen::VectorXd x = factor_.solve(Eigen::Map<const Eigen::VectorXd>(right.data(), at(right.size())));
    return {x.begin(), x.end()};
  }

  std::size_t entries() const override {
    return static_cast<std::size_t>(factor_.matrixL().nestedExpression().nonZeros() + factor_.vectorD().size());
  }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int64_t>;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<std::int64_t>> factor_;
  std::vector<std::int64_t> start_, row_;
};

}  // namespace

std::unique_ptr<SparseFactor> ldlt_cholesky() { return std::make_unique<Ldlt>(); }

}  // namespace jointid::minimise
