#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/equations/system_pattern.hpp"
#include "ident/plan/method.hpp"
#include "ident/result/control.hpp"
#include "ident/scene/method_traits.hpp"
#include "ident/variance/variances.hpp"

namespace jointid::ident {

/// Whether method "likelihood" takes each substructure with its own copy of the motions at its joints: where the scene asks for it
/// (solver = "by-parts"), or leaves the solver open, has more than eight substructures and 150 unknowns or more (any number where it asks
/// which joints are loose), has data for rows by parts, and nothing that these do not go with.
bool goes_by_parts(const Plan& plan);

/// Whether it does after all: with fewer unknowns, where the whole likelihood would take longer than a minute by its cost.
bool is_better_by_parts(const Plan& plan, const Cost& whole);

/// Plans that. Throws InputError for scenes with priors, a bootstrap, several starts, gains or masses, constraints, parts that are
/// coupled first or synthesised FRFs, and data without the motions at the joints.
PlannedMethod plan_by_parts(const Plan& plan, const StartPlanner& plan_start);

/// Whether the whole likelihood may take less time than the plan by parts, where the scene leaves the solver open: this takes
/// longer than a minute, and one group carries more than half of the unknowns.
bool may_be_quicker_whole(const Plan& plan, const PlannedMethod& parts);

/// By expected time; the whole one, and a note that says why, where it takes no longer.
PlannedMethod quicker(const Plan& plan, PlannedMethod parts, PlannedMethod whole);

/// Fisher's information of the FRFs of a plan by parts about the scaled unknowns, all substructures together: what no estimate by parts
/// can do better than.
struct WholeInformation {
  std::vector<Eigen::MatrixXd> of_lines;  ///< of so many pieces of the lines, one after the other
  std::vector<FileVariances> origins;
};

/// That at a joint (scaled unknowns), in `pieces` pieces at most; nothing for plans of other methods. Throws InputError for more unknowns
/// than a dense matrix may have.
std::optional<WholeInformation> information_by_parts(const Plan& plan, const std::vector<double>& theta, std::size_t pieces,
                                                     const Control& control);

/// Which unknowns its groups of substructures touch together; empty for plans of other methods, and below `least` unknowns.
std::optional<SystemPattern> pattern_by_parts(const Plan& plan, std::size_t least);

}  // namespace jointid::ident
