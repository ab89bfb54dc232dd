#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// Poles of maximum likelihood for the FRFs named, with all residues eliminated.
struct RefinedPoles {
  std::vector<Pole> poles;
  /// [2N,2N] row-major, of (ln f_1, damping_1, ln f_2, …): the inverse Fisher information, which is the Cramér–Rao bound when the
  /// weights are those of the noise.
  std::vector<double> covariance;
  double cost = 0.0;       ///< Σ |residual|²/σ²
  double freedom = 0.0;    ///< equations minus parameters
  std::size_t iterations = 0;
  bool converged = false;
};

struct RefineOptions {
  std::size_t most_iterations = 50;
  double step = 1e-3;  ///< converged when a step is smaller than this times the standard deviations: gᵀδ ≤
                       ///< step²·2N·max(cost/freedom, 0.01), or all are below 1e-14
};

/// Minimises Σ_entries ‖W(H − Xc)‖² over poles and residues by variable projection: Levenberg–Marquardt on the poles with
/// Kaufman's approximation of the projected Jacobian (Golub & Pereyra, SIAM J. Numer. Anal. 10 (1973); Kaufman, BIT 15 (1975)),
/// block by block, so that cost and memory grow linearly with the FRFs. The result does not depend on the number of threads.
/// `stop`, when given, ends it early, not converged.
RefinedPoles refine(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, std::vector<Pole> start,
                    const RefineOptions& options = {}, const std::function<bool()>& stop = {});

}  // namespace jointid::modalfit
