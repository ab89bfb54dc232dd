#pragma once

#include "ident/likelihood/data/estimated_frfs.hpp"

namespace jointid::ident {

/// The layout of some lines over these coordinates, of which the first `others` are not of the joint. H_sub(j,n) and H_sub(j,j)
/// are there whether measured or not, unless they are zero on every line; the rest where some line has it.
LineLayout choose_layout(const Dofs& coordinates, std::size_t others, const std::vector<BothSystems<Measured>>& lines);

/// The layout as if some coordinates (numbers in LineLayout::coordinates) had not been measured: non-joint ones at all, joint
/// ones on the assembly.
LineLayout without(LineLayout layout, const std::vector<std::size_t>& coordinates);

}  // namespace jointid::ident
