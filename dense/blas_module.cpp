#include "dense/blas_module.hpp"

#include "dense/one_blas_thread.hpp"

extern "C" {
using jointid_number = std::complex<double>;
void zherk_(const char*, const char*, const int*, const int*, const double*, const jointid_number*, const int*, const double*,
            jointid_number*, const int*);
void zgemm_(const char*, const char*, const int*, const int*, const int*, const jointid_number*, const jointid_number*,
            const int*, const jointid_number*, const int*, const jointid_number*, jointid_number*, const int*);
void zpotrf_(const char*, const int*, jointid_number*, const int*, int*);
void ztrsm_(const char*, const char*, const char*, const char*, const int*, const int*, const jointid_number*,
            const jointid_number*, const int*, jointid_number*, const int*);
int openblas_get_parallel();
}

namespace jointid::dense {
namespace {

class OpenBlas final : public BlasModule {
 public:
  bool is_safe_beside_threads() const override {
    constexpr int pthreads = 1;
    return openblas_get_parallel() == pthreads;
  }

  void add_square(double factor, int size, int depth, const Number* a, int a_step, Number* c, int c_step) override {
    const double one = 1.0;
    zherk_("L", "N", &size, &depth, &factor, a, &a_step, &one, c, &c_step);
  }

  void add_product(int rows, int columns, int depth, const Number* a, int a_step, const Number* b, int b_step, Number* c,
                   int c_step) override {
    const Number one = 1.0;
    zgemm_("N", "C", &rows, &columns, &depth, &one, a, &a_step, b, &b_step, &one, c, &c_step);
  }

  void subtract_adjoint_product(int rows, int columns, int depth, const Number* a, int a_step, const Number* b, int b_step, Number* c,
                                int c_step) override {
    const Number one = 1.0, minus = -1.0;
    zgemm_("C", "N", &rows, &columns, &depth, &minus, a, &a_step, b, &b_step, &one, c, &c_step);
  }

  bool cholesky(int size, Number* a, int a_step) override {
    int info = 0;
    zpotrf_("L", &size, a, &a_step, &info);
    return info == 0;
  }

  void solve_lower(bool adjoint, int size, int columns, const Number* l, int l_step, Number* b, int b_step) override {
    const Number one = 1.0;
    ztrsm_("L", "L", adjoint ? "C" : "N", "N", &size, &columns, &one, l, &l_step, b, &b_step);
  }
};

}  // namespace
}  // namespace jointid::dense

extern "C" void* jointid_module() {
  jointid::dense::use_one_blas_thread();
  static jointid::dense::OpenBlas module;
  return static_cast<jointid::dense::BlasModule*>(&module);
}
