#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frf/set/frf_system.hpp"

namespace jointid::coupling {

/// A structure whose FRFs are known.
struct Part {
  std::string name;  ///< as assemblies name it
  std::shared_ptr<frf::FrfSystem> system;
};

/// A coordinate of a part; without a part, of the only one that has it. A minus sign flips it.
struct PlacedDof {
  std::string part;
  frf::Dof dof;

  std::string name() const { return part.empty() ? dof.name() : part + "/" + dof.name(); }
};

/// Reads "4:+Y" or "PART/4:+Y". Throws InputError naming the text.
PlacedDof parse_placed_dof(const std::string& text);

/// A joint of known dynamic stiffness Z = K − ω²M + i(ωC + D) between coordinates. Each matrix is [n, n] row-major over `dofs`,
/// or empty for zero.
struct KnownJoint {
  std::vector<PlacedDof> dofs;
  std::vector<double> stiffness, mass, viscous_damping, hysteretic_damping;
};

/// What becomes of the parts, said in words that need no matrix.
struct Assembly {
  std::vector<std::vector<PlacedDof>> join;  ///< the DOFs of each list are one
  std::vector<PlacedDof> ground;             ///< held in place
  std::vector<KnownJoint> joints;
  std::vector<std::string> remove;  ///< parts that are taken out of the others (decoupling): −H in place of H
  /// Coordinates of the result. Empty: all of the parts that stay, of joined ones the first, and none that is grounded.
  std::vector<PlacedDof> keep;
  std::vector<PlacedDof> hide;  ///< coordinates that are not in the result
};

}  // namespace jointid::coupling
