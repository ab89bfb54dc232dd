#include <SuiteSparseQR.hpp>
#include <algorithm>
#include <numeric>

#include "dense/one_blas_thread.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::minimise {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

/// CHOLMOD's workspace for one solve.
class Common {
 public:
  Common() {
    cholmod_l_start(&common_);
    common_.print = 0;  // "not positive definite" would go to stdout
  }
  ~Common() { cholmod_l_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

/// CHOLMOD's factor of one pattern after the other.
class Cholmod final : public SparseFactor {
 public:
  ~Cholmod() override { forget(); }

  bool factorize(const SparseSymmetric& matrix) override {
    cholmod_sparse view = view_of(matrix);
    if (factor_ == nullptr || matrix.start != start_ || matrix.row != row_) {
      forget();
      start_ = matrix.start;
      row_ = matrix.row;
      common_.get()->nmethods = 1;
      common_.get()->method[0].ordering = CHOLMOD_AMD;
      common_.get()->postorder = 1;
      common_.get()->final_ll = 1;
      factor_ = cholmod_l_analyze(&view, common_.get());
    }
    if (factor_ == nullptr || cholmod_l_factorize(&view, factor_, common_.get()) == 0) return false;
    return common_.get()->status == CHOLMOD_OK && factor_->minor == factor_->n;
  }

  std::vector<double> solve(const std::vector<double>& right) override {
    cholmod_common* cc = common_.get();
    cholmod_dense* b = cholmod_l_zeros(right.size(), 1, CHOLMOD_REAL, cc);
    std::ranges::copy(right, static_cast<double*>(b->x));
    cholmod_dense* x = cholmod_l_solve(CHOLMOD_A, factor_, b, cc);
    const auto* first = static_cast<const double*>(x->x);
    std::vector<double> out(first, first + right.size());
    cholmod_l_free_dense(&x, cc);
    cholmod_l_free_dense(&b, cc);
    return out;
  }

  std::size_t entries() const override {
    const auto* counts = static_cast<const SuiteSparse_long*>(factor_->ColCount);
    return static_cast<std::size_t>(std::accumulate(counts, counts + factor_->n, SuiteSparse_long{0}));
  }

 private:
  void forget() {
    if (factor_ != nullptr) cholmod_l_free_factor(&factor_, common_.get());
  }

  static cholmod_sparse view_of(const SparseSymmetric& matrix) {
    cholmod_sparse view{};
    view.nrow = view.ncol = matrix.size();
    view.nzmax = matrix.value.size();
    view.p = const_cast<std::int64_t*>(matrix.start.data());
    view.i = const_cast<std::int64_t*>(matrix.row.data());
    view.x = const_cast<double*>(matrix.value.data());
    view.stype = -1;
    view.itype = CHOLMOD_LONG;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = 1;
    view.packed = 1;
    return view;
  }

  Common common_;
  cholmod_factor* factor_ = nullptr;
  std::vector<std::int64_t> start_, row_;
};

class Spqr final : public SpqrModule {
 public:
  std::unique_ptr<SparseFactor> cholesky() override { return std::make_unique<Cholmod>(); }

  SparseQr factor(const SparseEntries& a, const std::vector<double>& b, double tolerance) override {
    Common common;
    cholmod_common* cc = common.get();
    cholmod_triplet* triplet = cholmod_l_allocate_triplet(a.rows, a.columns, a.value.size(), 0, CHOLMOD_REAL, cc);
    std::ranges::copy(a.row, static_cast<SuiteSparse_long*>(triplet->i));
    std::ranges::copy(a.column, static_cast<SuiteSparse_long*>(triplet->j));
    std::ranges::copy(a.value, static_cast<double*>(triplet->x));
    triplet->nnz = a.value.size();
    cholmod_sparse* matrix = cholmod_l_triplet_to_sparse(triplet, triplet->nnz, cc);
    cholmod_l_free_triplet(&triplet, cc);
    cholmod_dense* right = cholmod_l_zeros(a.rows, 1, CHOLMOD_REAL, cc);
    std::ranges::copy(b, static_cast<double*>(right->x));

    cholmod_sparse* r = nullptr;
    cholmod_dense* q_right = nullptr;
    SuiteSparse_long* permutation = nullptr;
    const auto columns = static_cast<SuiteSparse_long>(a.columns);
    const SuiteSparse_long rank =
        SuiteSparseQR<double>(SPQR_ORDERING_AMD, tolerance, columns, matrix, right, &q_right, &r, &permutation, cc);
    const auto* start = static_cast<const SuiteSparse_long*>(r->p);
    const auto entries = static_cast<std::size_t>(start[r->ncol]);
    const auto* row = static_cast<const SuiteSparse_long*>(r->i);
    const auto* value = static_cast<const double*>(r->x);
    const auto* rotated = static_cast<const double*>(q_right->x);
    SparseQr out{{start, start + r->ncol + 1},      {row, row + entries}, {value, value + entries}, {}, 0,
                 {rotated, rotated + q_right->nrow}};
    if (permutation != nullptr) out.permutation.assign(permutation, permutation + a.columns);
    out.rank = static_cast<std::size_t>(std::max<SuiteSparse_long>(rank, 0));

    cholmod_l_free_dense(&q_right, cc);
    cholmod_l_free_dense(&right, cc);
    cholmod_l_free_sparse(&r, cc);
    cholmod_l_free_sparse(&matrix, cc);
    if (permutation != nullptr) cholmod_l_free(a.columns, sizeof(SuiteSparse_long), permutation, cc);
    return out;
  }
};

}  // namespace
}  // namespace jointid::minimise

extern "C" void* jointid_module() {
  jointid::dense::use_one_blas_thread();
  static jointid::minimise::Spqr module;
  return static_cast<jointid::minimise::SpqrModule*>(&module);
}
