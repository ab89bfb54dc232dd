#include "minimise/linear/sparse_qr.hpp"

#include "base/module.hpp"

namespace jointid::minimise {
namespace {

constexpr Module spqr{"spqr", "solver spqr", "libsuitesparse-dev"};

}  // namespace

SparseQr sparse_qr(const SparseEntries& a, const std::vector<double>& b, double tolerance) {
  return interface_of<SpqrModule>(spqr).factor(a, b, tolerance);
}

std::unique_ptr<SparseFactor> cholmod_cholesky() { return interface_of<SpqrModule>(spqr).cholesky(); }

bool has_spqr() { return is_there(spqr); }

}  // namespace jointid::minimise
