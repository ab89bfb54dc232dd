#pragma once

#include <vector>

#include "ident/likelihood/data/likelihood_data.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Joints of which nothing is known, guessed: springs between the first joint coordinates of each direction of two substructures,
/// between the second ones, … (where their numbers differ, or all are of one substructure, between all of a direction). A spring
/// between i and j is as stiff as the substructures there, 1/√(|H_ii||H_jj|) by the medians over the lines; where there are
/// rotations beside translations, in two more guesses those about axes are 100 times as stiff and as soft. Of what the
/// restriction allows each is the nearest, elements of K being measured in these stiffnesses; unknowns of other matrices are 0.
/// In scaled unknowns. There are none to ground: it holds rigid bodies, which puts resonances where the data have none. Empty
/// where no stiffness is unknown, no two joint coordinates have a direction in common, or an H_ii has not been measured.
std::vector<std::vector<double>> spring_starts(const Plan& plan, const LikelihoodData& data);

}  // namespace jointid::ident
