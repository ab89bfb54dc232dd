#pragma once

#include "response/stability/matrix_assembly.hpp"

namespace jointid::response {

/// What event-exact marching says of a solution of harmonic balance.
struct SolutionStability {
  PeriodicOrbit orbit;      ///< the exact one, by Newton's method from the solution (from rest where that does not close)
  double difference = 0.0;  ///< largest |x(0) − x_HB(0)|, over the largest amplitude Σ|X_n| of the solution
  std::vector<std::size_t> residual_force_free;  ///< joints that may keep any of a family of forces: a multiplier is exactly 1
};

/// Above this difference the orbit is another one than the solution meant.
inline constexpr double another_orbit = 0.5;

/// Shooting from a converged solution, with the multipliers by saltation (response.md §7).
SolutionStability stability(const MatrixAssembly& assembly, const Excitation& force, const HarmonicSolution& solution,
                            const OrbitOptions& options = {});

}  // namespace jointid::response
