#pragma once

#include <vector>

#include "base/random.hpp"
#include "frf/set/frf_set.hpp"
#include "problems/structure/response.hpp"
#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// Modal model of a structure with damping proportional to stiffness (docs/formulas.md §9).
struct Modes {
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;        ///< [n]
  std::vector<double> frequency_hz;  ///< [m] ascending; rigid-body modes are 0
  std::vector<double> loss_factor;   ///< [m] η_r; 0 for rigid-body modes
  std::vector<double> shapes;        ///< [n,m] row-major, ΦᵀMΦ = I

  std::size_t count() const { return frequency_hz.size(); }
};

/// All modes: Kφ = ω²Mφ by a dense generalized symmetric eigenvalue problem, η_r = φᵀDφ/ω_r². Modes with ω_r²
/// < 1e-11 ω_max², which is where the solver's rounding errors lie, count as rigid-body modes. Exact for D
/// proportional to K; other hysteretic damping keeps only its diagonal ΦᵀDΦ, viscous damping is ignored.
Modes modes(const Structure& structure);

/// H(ω) = Φ diag(1/(ω_r² − ω² + iη_rω_r²)) Φᵀ (5.65) at the request's DOFs; no window.
frf::FrfSet modal_response(const Modes& modes, const ResponseRequest& request);

/// "Consistent errors" (docs/formulas.md §9): every element of Φ, every ω_r and every η_r is multiplied by a factor
/// of its own, uniform in [1−p, 1+p]. The FRFs regenerated from them agree with each other but not with the
/// structure.
struct ConsistentErrors {
  double shape = 0.05;
  double frequency = 0.01;
  double damping = 0.01;
};
Modes with_consistent_errors(Modes modes, const ConsistentErrors& errors, const RandomStream& stream);

/// A set with the header of `clean` and the FRFs of modes with errors.
frf::FrfSet with_modal_errors(const frf::FrfSet& clean, const Modes& exact, const ConsistentErrors& errors,
                              const RandomStream& stream);

}  // namespace jointid::problems
