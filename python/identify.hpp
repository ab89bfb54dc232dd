#pragma once

#include <vector>

#include "frf/set/dof.hpp"
#include "python/outcome.hpp"
#include "python/scene_text.hpp"

namespace jointid::python {

/// `jointid solve`, of scenes of friction laws and of the joint at every line too. Throws InputError and Interrupted, as all of
/// these do; `so_far` gets what there is to be kept where it is interrupted.
Outcome solve(const SceneText& scene, const ident::Control& control, SoFar& so_far);

/// `jointid check`
Outcome check(const SceneText& scene, const ident::Control& control);

/// `jointid plan`
Outcome plan(const SceneText& scene, const ident::Control& control);

/// `jointid plan --bound`, of scenes of friction laws too; `candidates`: coordinates that are not measured yet.
Outcome bound(const SceneText& scene, const std::vector<frf::Dof>& candidates, const ident::Control& control, SoFar& so_far);

}  // namespace jointid::python
