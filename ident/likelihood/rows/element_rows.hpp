#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "restrictions/impedance_terms.hpp"

namespace jointid::ident {

/// Columns of numbers `stride` apart.
struct RowColumns {
  double* data;
  std::size_t stride;
};

/// What every row of a line has in common: the places of Y, how Z depends on the unknowns (none: no shapes), and how many other unknowns
/// there are, whose columns write_rows() leaves alone.
struct RowShape {
  std::span<const std::uint32_t> y_row, y_column;
  std::span<const restrictions::ImpedanceTerm> terms;
  std::span<const restrictions::ImpedanceShape> shapes;
  std::span<const restrictions::ImpedancePart> parts;
  std::size_t others = 0;

  /// Of the FRFs Y, the unknowns, the others and the residual.
  std::size_t tail() const { return first_other() + others + 1; }
  std::size_t first_other() const { return 2 * y_row.size() + parts.size(); }
  std::size_t residual() const { return tail() - 1; }
};

/// Of every left number N values of l, of λ and of x, of every right one of g, a and r, real and imaginary part in turn.
struct ElementTables {
  std::size_t joint;
  const double *left, *right;

  std::size_t numbers() const { return 6 * joint; }
};

/// Measured FRFs, a multiple of kernel_width many; those that fill up have weights of zero. Each changes by
///   by_left · lᵀ δX + by_right · gᵀ δX − lᵀ δY g + λᵀ δZ a,
/// δX a column of X, and is `base` − xᵀ g − lᵀ r off.
struct ElementGroup {
  std::size_t count;
  const std::uint32_t *left, *right;
  const double *weight_re, *weight_im, *base_re, *base_im, *by_left, *by_right;
};

/// Weighted coefficients of the group, real parts in the first `count` rows and imaginary parts in as many after them: to `tails` the
/// columns of RowShape::tail(), to `heads` those of the column of X, of which `run` has the rows. FRFs count as two real columns.
/// `room`: 16 · ElementTables::numbers().
void write_rows(const RowShape& shape, const ElementTables& tables, const ElementGroup& group, std::span<const std::uint32_t> run,
                RowColumns tails, RowColumns heads, double* room);

/// C(j, i) += Σ_r a(r, i) b(r, j) for `m` columns of A and `n` of B, `rows` a multiple of kernel_width; C column by column.
void add_dots(RowColumns c, RowColumns a, std::size_t m, RowColumns b, std::size_t n, std::size_t rows);

/// The same of B = A, for the lower triangle; what is above the diagonal is spoilt.
void add_dots_lower(RowColumns c, RowColumns a, std::size_t m, std::size_t rows);

/// What the columns of X that one element of D touches have in common: C(2j + …, 2i + …) gets the products of g(first_i) and l(second_j)
/// with squared weights.
void put_cross(RowColumns c, const double* g, std::span<const std::uint32_t> first, const double* l, std::span<const std::uint32_t> second,
               double square_re, double square_im);

}  // namespace jointid::ident
