#pragma once

#include <cstddef>

namespace jointid::dense {

/// C += AᵀA, the lower triangle, of columns of so many numbers that lie `stride` apart; C is `columns` × `columns`, by column.
void add_gram(const double* a, std::size_t rows, std::size_t columns, std::size_t stride, double* c);

}  // namespace jointid::dense
