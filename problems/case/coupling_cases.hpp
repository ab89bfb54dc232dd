#pragma once

#include <array>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "problems/case/case.hpp"
#include "problems/case/problem_noise.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// `number:+Y`.
inline frf::Dof coordinate(int number) { return {.node = number, .direction = frf::Direction::y}; }

/// The definition of a coupling problem over numbered coordinates, coordinate k being `k:+Y`.
struct CouplingCase {
  std::string name, description;
  std::vector<Structure> parts;
  std::vector<std::array<int, 2>> join;
  std::vector<int> ground;
  Axis axis;
  ProblemNoise noise;
  std::string couple;  ///< further keys of [couple], TOML
};

/// Cases A, B and C of thesis §5.9. Figures 5.8, 5.10 and 5.16, which would show masses and springs, are not available; those
/// here are ours (docs/problems.md).
std::vector<CouplingCase> all_coupling_cases();

}  // namespace jointid::problems
