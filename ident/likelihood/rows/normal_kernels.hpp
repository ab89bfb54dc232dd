#pragma once

#include <cstddef>

namespace jointid::ident {

/// Of so many neighbouring numbers the kernels take multiples.
inline constexpr std::size_t kernel_width = 8;

/// The next multiple of kernel_width: what the kernels take for so many numbers.
constexpr std::size_t widths_of(std::size_t count) { return (count + kernel_width - 1) / kernel_width * kernel_width; }

/// From where on the kernels read a column of a lower triangle.
constexpr std::size_t lower_part(std::size_t column) { return column / kernel_width * kernel_width; }

/// Rows of numbers `stride` apart.
struct ConstRows {
  const double* data;
  std::size_t stride;
};

/// Column i of C, from its first number on, gets Σ_r a(r, i) b(r, ·): m columns, n numbers of each (a multiple of kernel_width),
/// `count` rows.
void add_products(double* c, std::size_t stride, ConstRows a, std::size_t m, ConstRows b, std::size_t n, std::size_t count);

/// The first v columns of the lower triangle of a symmetric matrix of `size` by their Cholesky factor L and L⁻¹W below it, the rest by its
/// Schur complement: [U Wᵀ; W V] → [L; W L⁻ᵀ; V − W U⁻¹Wᵀ]. Column by column, `stride` (a multiple of kernel_width, at least `size`)
/// apart, behind the last one room for kernel_width numbers; what is above the diagonal is spoilt. False where U is not positive
/// definite: all is spoilt then.
bool eliminate(double* matrix, std::size_t stride, std::size_t v, std::size_t size);

/// U⁻¹W of eliminate(): `out` has v rows, widths_of(size − v) apart.
void solve_eliminated(const double* matrix, std::size_t stride, std::size_t v, std::size_t size, double* out);

/// U⁻¹x in place of x.
void solve_by_factor(const double* matrix, std::size_t stride, std::size_t v, double* x);

}  // namespace jointid::ident
