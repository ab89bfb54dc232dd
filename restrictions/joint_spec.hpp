#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::restrictions {

/// The four real matrices of Z_j(ω) = K − ω²M + i(ωC + D) (docs/formulas.md §1, 6.28).
enum class Kind { stiffness, mass, viscous_damping, hysteretic_damping };
inline constexpr std::array<Kind, 4> all_kinds = {Kind::stiffness, Kind::mass, Kind::viscous_damping,
                                                  Kind::hysteretic_damping};

std::string key(Kind kind);     ///< "stiffness", "mass", "viscous_damping", "hysteretic_damping"
std::string symbol(Kind kind);  ///< "K", "M", "C", "D"

/// A pattern by name.
enum class Pattern {
  full,       ///< every element its own unknown
  symmetric,  ///< upper triangle
  diagonal,   ///<
  free        ///< symmetric, and no force under rigid-body motion; needs node positions
};

/// One entry of a matrix as written in the scene: a number, or a linear expression such as "2*k+m" or "-a".
using Entry = std::variant<double, std::string>;
using EntryMatrix = std::vector<std::vector<Entry>>;

/// A spring (or mass or damper) between two DOFs, or from a DOF to ground when `second` is empty.
struct Spring {
  frf::Dof first;
  std::optional<frf::Dof> second;
};

using MatrixSpec = std::variant<Pattern, EntryMatrix, std::vector<Spring>>;

/// One joint as the scene declares it. A matrix that is absent is zero and costs nothing.
struct JointSpec {
  std::string name;  ///< empty when the scene has one joint only; else the prefix of its unknowns
  std::vector<frf::Dof> dofs;
  std::map<Kind, MatrixSpec> matrices;
  std::set<Kind> definite{};  ///< matrices that are required to be positive semidefinite
  /// Frequency bands [lo, hi) in Hz over which the unknowns of this joint are identified separately; empty: one for all.
  std::vector<std::array<double, 2>> bands_hz;
  std::map<std::int64_t, std::array<double, 3>> node_positions;  ///< m; used by Pattern::free only
};

}  // namespace jointid::restrictions
