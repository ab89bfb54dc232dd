#pragma once

#include <string_view>

#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

/// Iterations of chapter 4 of Ren's thesis without a Jacobian. All of them are
/// Q_n ← (I + G_nK_n)⁻¹(b_n − G_n(F_n(Q) − K_nQ_n)), harmonic by harmonic, with another diagonal K_n (N/m) of the joints.
enum class Scheme {
  direct,      ///< K = 0: Q = b − GF(Q) (4.35)
  equivalent,  ///< ESD, K = F₁/Q₁ = k_e + id_e (4.51): equations with a single harmonic
  local,       ///< LESD, K_n = e^{−iφ_n} ∂F_n/∂|Q_n|, phase and other harmonics held (4.58, 4.60)
  wirtinger    ///< LESD with K_n = ½(∂_Re − i∂_Im)F_n, which uses both directions
};
std::string_view word(Scheme scheme);

/// How an iteration ended.
enum class IterationState {
  converged,  ///< ‖Q − map(Q)‖ < tolerance ‖Q‖ (4.54)
  stalled,    ///< no smaller ‖Q − map(Q)‖ was found along the step, or no step exists
  limit       ///< most_steps were not enough
};
std::string_view word(IterationState state);

struct IterationOptions {
  double tolerance = 1e-10;
  int most_steps = 300;
  bool search = true;  ///< where ‖Q − map(Q)‖ grows, its least value along the step is taken (4.52, 4.53)
};

struct Iteration {
  IterationState state = IterationState::limit;
  int steps = 0;
  int searches = 0;        ///< steps that were shortened
  double distance = 0.0;   ///< ‖Q − map(Q)‖/‖Q‖ at the end
  Eigen::VectorXd motion;  ///< the last Q, layout of CondensedEquations
};

/// Whether the scheme is defined for these equations: ESD needs a single harmonic.
bool defined(Scheme scheme, const CondensedEquations& equations);

/// One step of the scheme without a search, map(Q). Throws InputError (usage) where it is not defined.
Eigen::VectorXd stepped(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line, double level,
                        const Eigen::VectorXd& motion);

/// Steps from `start` until one of the states. `direct` is never searched, as in the thesis.
Iteration iterate(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line, double level,
                  Eigen::VectorXd start, const IterationOptions& options = {});

/// ρ((I + GK)⁻¹G(∂F/∂Q − K)), the factor by which an error falls in one step near the solution `motion`; the scheme converges
/// there if and only if it is below 1 (4.40). F is not analytic, so the matrix is real, of the unknowns of Harmonics.
double convergence_factor(Scheme scheme, const CondensedEquations& equations, const HarmonicLine& line,
                          const Eigen::VectorXd& motion);

}  // namespace jointid::response
