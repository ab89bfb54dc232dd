#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "response/identify/fit_work.hpp"
#include "response/identify/law_unknowns.hpp"
#include "response/identify/line_correlation.hpp"

namespace jointid::response {

/// Where a lifted fit ended: near a minimum of the likelihood, and what the states are there.
struct LiftedFit {
  Eigen::VectorXd numbers;              ///< of LawUnknowns
  LineLayout layout;                    ///< of these harmonics
  LineErrors errors;                    ///< of the receptances
  std::vector<StatePrediction> states;  ///< harmonics, motions and forces of the joints: where harmonic balance starts
  double chi_square = 0.0;              ///< Σ|X − Y|²/σ² + Σu², the law's forces being met to the last tolerance
  int steps = 0;
};

/// The likelihood with the forces of the joints as unknowns of their own ("lifted": Albersmeyer and Diehl 2010, SIAM J. Optim.
/// 20, 1655–1684): min over θ, F and the errors u of Σ|X(F, u) − Y|²/σ² + Σ|F − F(Q(F, u); θ)|²/τ² + Σu². No equation is solved,
/// so that near resonances, where harmonic balance amplifies every error, the sum stays smooth; it starts at the forces of the
/// direct step. τ falls from a third of the joint's force to a hundredth of it, each minimum the start of the next; with τ → 0 it
/// is the likelihood. Gauss–Newton steps, the unknowns of a line eliminated from its rows. Of 40 lines and more, 20 among them
/// tell the numbers first; all then start where harmonic balance has them, if it does. Nothing when direct_step cannot start it.
std::optional<LiftedFit> fit_lifted(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                    const LawUnknowns& unknowns, const std::vector<int>& harmonics, const FitWork& work = {});

/// The same from where a fit ended, perhaps with other harmonics: tolerances from 1e-2 to 1e-4; forces of new harmonics begin as the
/// law's.
std::optional<LiftedFit> fit_lifted(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                    const LawUnknowns& unknowns, const std::vector<int>& harmonics, const LiftedFit& from,
                                    const FitWork& work = {});

}  // namespace jointid::response
