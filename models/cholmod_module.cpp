#include <cholmod.h>

#include "dense/one_blas_thread.hpp"
#include "models/sparse_factors.hpp"

namespace jointid::models {
namespace {

class Supernodal final : public PositiveFactors {
 public:
  Supernodal() {
    cholmod_start(&common_);
    common_.print = 0;  // "not positive definite" would go to stdout
    common_.supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Supernodal() override {
    if (factor_ != nullptr) cholmod_free_factor(&factor_, &common_);
    cholmod_finish(&common_);
  }
  Supernodal(const Supernodal&) = delete;
  Supernodal& operator=(const Supernodal&) = delete;

  bool factorize(const Eigen::SparseMatrix<double>& matrix) override {
    Eigen::SparseMatrix<double> lower = matrix.triangularView<Eigen::Lower>();
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    view.p = lower.outerIndexPtr();
    view.i = lower.innerIndexPtr();
    view.x = lower.valuePtr();
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    if (factor_ != nullptr) cholmod_free_factor(&factor_, &common_);
    factor_ = cholmod_analyze(&view, &common_);
    if (factor_ == nullptr || cholmod_factorize(&view, factor_, &common_) == 0) return false;
    return common_.status == CHOLMOD_OK && factor_->minor == factor_->n;
  }

  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) override {
    cholmod_dense view{};
    view.nrow = view.d = static_cast<std::size_t>(b.rows());
    view.ncol = static_cast<std::size_t>(b.cols());
    view.nzmax = static_cast<std::size_t>(b.size());
    view.x = const_cast<double*>(b.data());
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor_, &view, &common_);
    Eigen::MatrixXd out = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(x->x), b.rows(), b.cols());
    cholmod_free_dense(&x, &common_);
    return out;
  }

  bool is_supernodal() const override { return true; }

 private:
  cholmod_common common_{};
  cholmod_factor* factor_ = nullptr;
};

class Cholmod final : public CholmodModule {
 public:
  std::unique_ptr<PositiveFactors> supernodal() override { return std::make_unique<Supernodal>(); }
};

}  // namespace
}  // namespace jointid::models

extern "C" void* jointid_module() {
  jointid::dense::use_one_blas_thread();
  static jointid::models::Cholmod module;
  return static_cast<jointid::models::CholmodModule*>(&module);
}
