#include "tasks/response/run_response.hpp"

#include <utility>

#include "tasks/response/clamping_run.hpp"
#include "tasks/response/further_runs.hpp"
#include "tasks/response/level_runs.hpp"

namespace jointid::tasks {
namespace {

ResponseResult run(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, LevelsSoFar before,
                   const KeepLevels& keep) {
  ResponseResult result;
  result.doubts = prepared.doubts;
  for (const SceneJoint& joint : scene.joints) result.joints.push_back(joint.joint.name);
  for (const SceneDof& dof : scene.responses) result.dofs.push_back(dof.name);
  if (!scene.levels.empty()) {
    const response::HarmonicBalance balance(prepared.structure, joints_of(scene), scene.force, scene.harmonics);
    result.levels = std::move(before.finished);
    run_levels(balance, scene, prepared, control, result, std::move(before.begun), keep);
    run_curves(balance, scene, control, result);
    run_clamping(scene, prepared, control, result);
  }
  run_equivalents(scene, prepared, result);
  run_transients(scene, prepared, control, result);
  return result;
}

}  // namespace

ResponseResult run_response(const ResponseScene& scene, const ident::Control& control, LevelsSoFar before, const KeepLevels& keep) {
  return run(scene, prepare(scene, control), control, std::move(before), keep);
}

ResponseResult run_response(const ResponseScene& scene, std::vector<frf::FrfSet> parts, const ident::Control& control) {
  return run(scene, prepare(scene, std::move(parts), control), control, {}, {});
}

}  // namespace jointid::tasks
