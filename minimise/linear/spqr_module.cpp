#include <SuiteSparseQR.hpp>
#include <algorithm>

#include "dense/one_blas_thread.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::minimise {
namespace {

static_assert(sizeof(SuiteSparse_long) == sizeof(std::int64_t));

/// CHOLMOD's workspace for one solve.
class Common {
 public:
  Common() { cholmod_l_start(&common_); }
  ~Common() { cholmod_l_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

class Spqr final : public SpqrModule {
 public:
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
        SuiteSparseQR<double>(SPQR_ORDERING_DEFAULT, tolerance, columns, matrix, right, &q_right, &r, &permutation, cc);
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
