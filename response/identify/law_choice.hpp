#pragma once

#include <string>

#include "response/identify/force_fit.hpp"
#include "response/identify/law_constraints.hpp"
#include "response/identify/law_fit.hpp"

namespace jointid::response {

/// A law for each joint, and what fit_laws makes of it.
struct LawCandidate {
  std::vector<std::string> laws;
  LawFit fit;
};

/// Joints with these laws (friction::fitted_laws) to start with: first those of fit_forces on the direct step, then the families'
/// starts that are nearest to the forces; `beside`: name, spring, dashpot and cubic spring of each joint. Unknown springs and
/// dashpots of 0 begin at a tenth of the law's initial stiffness, tied joints with the law that they are tied to. Throws
/// InputError where direct_step or fit_forces do, or when a law suits no force.
std::vector<std::vector<Joint>> law_starts(const Receptance& structure, const std::vector<MeasuredState>& states,
                                           const std::vector<std::string>& laws, const std::vector<Joint>& beside,
                                           const LawConstraints& constraints = {});

/// fit_laws from each start, with the measured harmonics alone where harmonics are added, until the data do not contradict one;
/// or two end in one
/// minimum; then, from the one with the smallest AIC of those that converged, as the options say. Several starts, as parameters of a law
/// can run to where nothing depends on them (Iwan's β to 0) and stay there.
LawFit fit_from(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                const std::vector<std::vector<Joint>>& starts, const LawFitOptions& options = {},
                const LawConstraints& constraints = {});

/// Every candidate fitted as by fit_from, those first whose forces are nearest to the direct step's; where two starts of a law,
/// one with the stiffnesses and limits of the best before it, end four times as bad as a law that the data do not contradict, no
/// other is tried. Those that the data do not contradict, but whose χ² is above that of the best by more than 1, again from
/// starts with its stiffnesses and limits; those whose first fit is four times as bad as the best one get no further harmonics.
/// Those that converged first, of them those with the smallest AIC = χ² + 2 · unknowns.
std::vector<LawCandidate> compare_laws(const std::shared_ptr<const Receptance>& structure,
                                       const std::vector<MeasuredState>& states,
                                       const std::vector<std::vector<std::string>>& candidates, const std::vector<Joint>& beside,
                                       const LawFitOptions& options = {}, const LawConstraints& constraints = {});

/// Of what compare_laws gives the place of the law to name: of those within 2 of the smallest AIC, which explain the data as
/// well, the one with the fewest unknowns. A law that has another as its limit (Ren's with b → 0 is the bilinear one) takes its
/// place by chance in 4.6 % of the cases (χ² of one degree above 4) with one more unknown.
std::size_t chosen_law(const std::vector<LawCandidate>& compared);

}  // namespace jointid::response
