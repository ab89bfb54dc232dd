#pragma once

#include <cstddef>

namespace jointid::dense {

/// C += AᵀA, the lower triangle, of columns of so many numbers that lie `stride` apart; C is `columns` × `columns`, by column.
void add_gram(const double* a, std::size_t rows, std::size_t columns, std::size_t stride, double* c);

/// C += AᵀB of columns of so many numbers, one after the other; C is `columns_a` × `columns_b`, by column.
void add_cross(const double* a, std::size_t columns_a, const double* b, std::size_t columns_b, std::size_t rows, double* c);

}  // namespace jointid::dense
