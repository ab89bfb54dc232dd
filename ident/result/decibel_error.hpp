#pragma once

#include <cstddef>

#include "minimise/linear/line_product.hpp"

namespace jointid::ident {

/// FRFs this far below the largest of their line (180 dB) count as zero: no measurement has that range, but FRFs that vanish
/// by symmetry leave rounding errors there, whose ratio says nothing.
inline constexpr double zero_level = 1e-9;

/// Sum of squares of 20 log10(|predicted|/|measured|) over the entries where both are finite and not zero.
struct DecibelError {
  double sum_of_squares = 0.0;
  std::size_t entries = 0;
};

/// Distance from row to row of `right` below: columns rounded up to whole panels.
std::size_t padded(std::size_t columns);

/// Adds one line: predicted = base − left·right with left [R×N] and right [N×C], split into real and imaginary parts and
/// row-major, the rows of `right` padded(C) apart; base and measured [R×C].
void add_decibel_error(const minimise::View& base, const double* left_re, const double* left_im, const double* right_re,
                       const double* right_im, std::size_t n, const minimise::View& measured, DecibelError& error);

}  // namespace jointid::ident
