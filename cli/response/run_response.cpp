#include "cli/response/run_response.hpp"

#include "cli/response/further_runs.hpp"
#include "cli/response/level_runs.hpp"

namespace jointid::cli {

ResponseRun run_response(const ResponseScene& scene, Progress& progress) {
  const Prepared prepared = prepare(scene);
  ResponseRun run;
  run.doubts = prepared.doubts;
  for (const SceneJoint& joint : scene.joints) run.joints.push_back(joint.joint.name);
  for (const SceneDof& dof : scene.responses) run.dofs.push_back(dof.name);
  if (!scene.levels.empty()) {
    const response::HarmonicBalance balance(prepared.structure, joints_of(scene), scene.force, scene.harmonics);
    run_levels(balance, scene, prepared, progress, run);
    run_curves(balance, scene, progress, run);
  }
  run_equivalents(scene, prepared, run);
  run_transients(scene, prepared, progress, run);
  return run;
}

}  // namespace jointid::cli
