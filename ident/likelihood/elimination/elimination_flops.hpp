#pragma once

#include "ident/likelihood/elimination/arrow_layout.hpp"

namespace jointid::ident {

/// Real additions and multiplications of a line with circular errors, with so many right-hand sides, the residuals among them:
/// normal equations, Cholesky factors and solutions. By the rows of all that is measured (ComplexRows), in O(N⁶):
double flops_by_rows(const LineLayout& layout, std::size_t right_sides);
/// By LineElimination, in O(N⁶) too, but a fourth of it or less where Y has more FRFs than X has in a column and D does not have
/// most of all:
double flops_by_elimination(const LineLayout& layout, std::size_t right_sides);
/// By ArrowElimination: in O(N⁶) by the core alone.
double flops_by_arrow(const LineLayout& layout, const ArrowLayout& arrow, std::size_t right_sides);

/// Whether LineElimination is a faster way than ArrowElimination, of lines that are large.
bool elimination_pays(const LineLayout& layout, std::size_t right_sides);

}  // namespace jointid::ident
