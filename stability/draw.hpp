#pragma once

#include "stability/extreme_scene.hpp"

namespace jointid::stability {

/// An extreme scene drawn at random: every quantity of ExtremeScene over the whole range of the sweeps, log-uniform where it
/// has decades. Scene `index` of a seed is the same whatever else is drawn.
ExtremeScene draw(std::uint64_t seed, std::uint64_t index);

/// The solver to go with it: qr, spqr or normal.
ident::Solver draw_solver(std::uint64_t seed, std::uint64_t index);

}  // namespace jointid::stability
