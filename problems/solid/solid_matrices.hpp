#pragma once

#include "models/structure_matrices.hpp"
#include "problems/structure/brick.hpp"

namespace jointid::problems {

/// The matrices of solid_block() as sparse ones, coordinates x, y, z of each node in the order of Block::node().
models::StructureMatrices solid_matrices(const Solid& solid, const Block& block);

}  // namespace jointid::problems
