#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"

namespace jointid::ident {

/// Looks for mistakes in the FRFs of a plan: reads lines of its files once (at most 64 MB of values, evenly spread over the
/// lines of the scene), compares H_ij with H_ji, the sign of driving points, and the assembly with its parts: with forces at the
/// joint alone, H_asm − H_sub lies in the span of H_sub(:, J) and of H_sub(J, :). Where something stands out, each mistake it
/// knows is undone on trial; the one that heals most comes first.
CheckResult check_data(const Plan& plan, const Control& control = {});

/// The same of a scene whose data no plan needs to fit: a mistaken label may be one that the joint or the equations need. FRFs as
/// measured, before a modal model replaces them.
CheckResult check_scene(const Scene& scene, const Control& control = {});
CheckResult check_systems(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures, std::shared_ptr<frf::FrfSystem> assembly,
                          const Control& control = {});

/// The same on at most 24 lines: for solve and plan, where the data are read for something else.
CheckResult quick_check(const Plan& plan, const Control& control = {});

/// What makes every joint of a scene miss FRFs that are right, as far as it may apply: the mass of the joint, its law of damping, a DOF
/// left out, modes that a model lacks, another level of force.
std::string other_causes(const Scene& scene);

}  // namespace jointid::ident
