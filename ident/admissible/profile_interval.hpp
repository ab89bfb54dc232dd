#pragma once

#include <array>
#include <vector>

#include "ident/admissible/admissible_set.hpp"

namespace jointid::ident {

/// 95 % intervals of all unknowns under constraints, by the profile likelihood: {θ_i | min χ²(θ) − min χ² ≤ 1.96²}, both minima
/// over the set, χ²(θ) = ‖R(θ − θ̂)‖². They hold a bound that is reached, and are narrower for its neighbours, too. `estimate` is
/// θ̂, which meets the ties; [columns × columns] `root` is R. Each end is the θ_i of the set's nearest point to θ̂ moved along the
/// covariance of the unknown, moved until χ² has risen so far; to 1e-3 of the standard deviation.
std::vector<std::array<double, 2>> profile_intervals(const AdmissibleSet& set, const Eigen::VectorXd& estimate,
                                                     const Eigen::MatrixXd& root);

/// The shortest interval with 95 % of a normal distribution of this centre and deviation cut off at lower ≤ x ≤ upper: its
/// highest density. Where nothing to speak of is inside, the bound next to the centre.
std::array<double, 2> densest_interval(double centre, double deviation, double lower, double upper);

}  // namespace jointid::ident
