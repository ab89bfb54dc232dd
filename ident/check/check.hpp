#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/suspect.hpp"

namespace jointid::ident {

/// Looks for errors in the FRFs of a plan. It reads lines of its files once (at most 64 MB of values, evenly spread over the
/// lines of the scene). It compares H_ij with H_ji, the sign of driving points, and the assembly with its parts: with forces at
/// the joint only, H_asm − H_sub is in the span of H_sub(:, J) and H_sub(J, :). For an outlier it undoes each known error on
/// trial; the one that removes most comes first.
CheckResult check_data(const Plan& plan, const Control& control = {});

/// The same for a scene whose data need not fit a plan, as a wrong label may be a DOF of the joint or the equations. FRFs as
/// measured, before a modal model replaces them.
CheckResult check_scene(const Scene& scene, const Control& control = {});
CheckResult check_systems(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures, std::shared_ptr<frf::FrfSystem> assembly,
                          const Control& control = {});

/// The same on at most 24 lines, for solve and plan.
CheckResult quick_check(const Plan& plan, const Control& control = {});

/// Causes that make every joint of a scene miss correct FRFs, if they can apply: the mass of the joint, its damping law, a DOF
/// left out, missing modes of a model, another force level.
std::string other_causes(const Scene& scene);

}  // namespace jointid::ident
