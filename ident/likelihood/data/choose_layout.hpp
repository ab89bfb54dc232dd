#pragma once

#include "ident/likelihood/data/estimated_frfs.hpp"

namespace jointid::ident {

/// On how many lines an element of a block is not zero, and on how many it is known, of all elements of X, Y, A, B and D (LineLayout)
/// over some coordinates, of which the first `others` are not of the joint. Those of several processes add up.
std::vector<double> count_elements(std::size_t coordinates, std::size_t others, const std::vector<BothMeasured>& lines);

/// The layout of lines counted so. H_sub(j,n) and H_sub(j,j) are there whether measured or not, unless they are zero on every line; the
/// rest where some line has it.
LineLayout choose_layout(const Dofs& coordinates, std::size_t others, const std::vector<double>& counts);

/// The layout as if some coordinates (numbers in LineLayout::coordinates) had not been measured: non-joint ones at all, joint
/// ones on the assembly.
LineLayout without(LineLayout layout, const std::vector<std::size_t>& coordinates);

}  // namespace jointid::ident
