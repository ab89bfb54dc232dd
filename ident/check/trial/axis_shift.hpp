#pragma once

#include <vector>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// The FRFs of a file at (1 + ε) times the frequencies of some of its lines, [line]. Around each, all FRFs of the file are
/// (a + bx + cx²)/d(x), x = f², with one denominator d of second order, by least squares over six neighbouring lines:
/// min Σ|d H − n|², |d| = 1. Lines where a value is missing, and files of fewer than six lines, give NaN.
std::vector<Eigen::MatrixXcd> shifted_frfs(const CheckedFile& file, const std::vector<std::size_t>& lines, double epsilon);

}  // namespace jointid::ident
