#include "dense/blas.hpp"

#include <Eigen/Cholesky>

#include "base/error.hpp"
#include "base/module.hpp"
#include "dense/blas_module.hpp"

namespace jointid::dense {
namespace {

using Eigen::MatrixXcd;
using Eigen::Ref;

/// Products of complex numbers from which on the module pays: OpenBLAS is three times as fast as Eigen's products for every x86-64 from
/// 500 on, but a scene that never gets here does not load it.
constexpr Eigen::Index large = 2500;

constexpr Module open_blas{"blas", "large complex products", "libopenblas-pthread-dev"};

/// The module for so many products; null: Eigen.
BlasModule* blas_for(Eigen::Index products) {
  if (products < large) return nullptr;
  static BlasModule* const module = []() -> BlasModule* {
    try {
      BlasModule* const found = has_blas() ? &interface_of<BlasModule>(open_blas) : nullptr;
      return found != nullptr && found->is_safe_beside_threads() ? found : nullptr;
    } catch (const InputError&) {
      return nullptr;  // its library is gone; Eigen does all that it does
    }
  }();
  return module;
}

int whole(Eigen::Index i) { return static_cast<int>(i); }

void add_square(double factor, const Ref<const MatrixXcd>& a, Ref<MatrixXcd> c) {
  if (a.cols() == 0) return;  // Eigen divides by it
  if (BlasModule* blas = blas_for(a.rows() * a.rows() * a.cols() / 2)) {
    blas->add_square(factor, whole(a.rows()), whole(a.cols()), a.data(), whole(a.outerStride()), c.data(), whole(c.outerStride()));
  } else {
    c.selfadjointView<Eigen::Lower>().rankUpdate(a, factor);
  }
}

}  // namespace

bool has_blas() { return is_there(open_blas); }

void add_square(const Ref<const MatrixXcd>& a, Ref<MatrixXcd> c) { add_square(1.0, a, c); }

void subtract_square(const Ref<const MatrixXcd>& a, Ref<MatrixXcd> c) { add_square(-1.0, a, c); }

void add_product(const Ref<const MatrixXcd>& a, const Ref<const MatrixXcd>& b, Ref<MatrixXcd> c) {
  if (BlasModule* blas = blas_for(a.rows() * b.rows() * a.cols())) {
    blas->add_product(whole(a.rows()), whole(b.rows()), whole(a.cols()), a.data(), whole(a.outerStride()), b.data(),
                      whole(b.outerStride()), c.data(), whole(c.outerStride()));
  } else {
    c.noalias() += a * b.adjoint();
  }
}

void subtract_adjoint_product(const Ref<const MatrixXcd>& a, const Ref<const MatrixXcd>& b, Ref<MatrixXcd> c) {
  if (BlasModule* blas = blas_for(a.rows() * a.cols() * b.cols())) {
    blas->subtract_adjoint_product(whole(a.cols()), whole(b.cols()), whole(a.rows()), a.data(), whole(a.outerStride()), b.data(),
                                   whole(b.outerStride()), c.data(), whole(c.outerStride()));
  } else {
    c.noalias() -= a.adjoint() * b;
  }
}

bool cholesky_in_place(Ref<MatrixXcd> a) {
  if (BlasModule* blas = blas_for(a.rows() * a.rows() * a.rows() / 6))
    return blas->cholesky(whole(a.rows()), a.data(), whole(a.outerStride()));
  return Eigen::LLT<Ref<MatrixXcd>>(a).info() == Eigen::Success;
}

void solve_lower(const Ref<const MatrixXcd>& l, Ref<MatrixXcd> b) {
  if (BlasModule* blas = blas_for(l.rows() * l.rows() * b.cols() / 2)) {
    blas->solve_lower(false, whole(l.rows()), whole(b.cols()), l.data(), whole(l.outerStride()), b.data(),
                      whole(b.outerStride()));
  } else {
    l.triangularView<Eigen::Lower>().solveInPlace(b);
  }
}

void solve_lower_adjoint(const Ref<const MatrixXcd>& l, Ref<MatrixXcd> b) {
  if (BlasModule* blas = blas_for(l.rows() * l.rows() * b.cols() / 2)) {
    blas->solve_lower(true, whole(l.rows()), whole(b.cols()), l.data(), whole(l.outerStride()), b.data(), whole(b.outerStride()));
  } else {
    l.triangularView<Eigen::Lower>().adjoint().solveInPlace(b);
  }
}

}  // namespace jointid::dense
