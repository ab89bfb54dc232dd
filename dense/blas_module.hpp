#pragma once

#include <complex>
#include <cstddef>

namespace jointid::dense {

/// What the module blas implements (base/module.hpp). Matrices lie column by column, with `…_step` numbers from one column to the
/// next.
class BlasModule {
 public:
  using Number = std::complex<double>;

  virtual ~BlasModule() = default;
  /// Whether several threads may call at once. Builds of OpenBLAS without threads have no locks round their buffers (21 of 160,000
  /// products were wrong on two threads), those of OpenMP none that other threads respect.
  virtual bool is_safe_beside_threads() const = 0;
  /// C += factor · A Aᴴ, lower; A is size × depth.
  virtual void add_square(double factor, int size, int depth, const Number* a, int a_step, Number* c, int c_step) = 0;
  /// C += A Bᴴ; C is rows × columns.
  virtual void add_product(int rows, int columns, int depth, const Number* a, int a_step, const Number* b, int b_step, Number* c,
                           int c_step) = 0;
  /// C −= Aᴴ B; C is rows × columns.
  virtual void subtract_adjoint_product(int rows, int columns, int depth, const Number* a, int a_step, const Number* b, int b_step,
                                        Number* c, int c_step) = 0;
  virtual bool cholesky(int size, Number* a, int a_step) = 0;
  /// L⁻¹ B, with `adjoint` L⁻ᴴ B.
  virtual void solve_lower(bool adjoint, int size, int columns, const Number* l, int l_step, Number* b, int b_step) = 0;
};

}  // namespace jointid::dense
