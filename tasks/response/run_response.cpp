#include "tasks/response/run_response.hpp"

#include "tasks/response/further_runs.hpp"
#include "tasks/response/level_runs.hpp"

namespace jointid::tasks {

ResponseResult run_response(const ResponseScene& scene, const ident::Control& control) {
  const Prepared prepared = prepare(scene, control);
  ResponseResult run;
  run.doubts = prepared.doubts;
  for (const SceneJoint& joint : scene.joints) run.joints.push_back(joint.joint.name);
  for (const SceneDof& dof : scene.responses) run.dofs.push_back(dof.name);
  if (!scene.levels.empty()) {
    const response::HarmonicBalance balance(prepared.structure, joints_of(scene), scene.force, scene.harmonics);
    run_levels(balance, scene, prepared, control, run);
    run_curves(balance, scene, control, run);
  }
  run_equivalents(scene, prepared, run);
  run_transients(scene, prepared, control, run);
  return run;
}

}  // namespace jointid::tasks
