#pragma once

#include <functional>
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

/// The errors of a joint that was identified: δZ = Σ θ_m ∂Z/∂θ_m of its unknowns' errors θ, which are real.
struct JointUncertainty {
  struct Unknown {
    std::vector<double> stiffness, mass, viscous_damping, hysteretic_damping;  ///< derivatives of the matrices of a KnownJoint
  };
  std::vector<Unknown> unknowns;   ///< [p]
  std::vector<double> covariance;  ///< [p,p] E[θ θᵀ]

  /// E[ε θ_m] of the error ε of an FRF of a part on a line: what the joint has of it, as it was found from that FRF among others. [p],
  /// or empty: nothing.
  using Common = std::function<std::vector<Complex>(const std::string& part, const frf::Dof& row, const frf::Dof& column, double hz)>;
  Common common{};
};

/// A joint of known dynamic stiffness Z = K − ω²M + i(ωC + D) between coordinates. Each matrix is [n, n] row-major over `dofs`,
/// or empty for zero.
struct KnownJoint {
  std::vector<PlacedDof> dofs;
  std::vector<double> stiffness, mass, viscous_damping, hysteretic_damping;
  std::shared_ptr<const JointUncertainty> uncertainty{};  ///< none: the matrices are exact
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
