#include "ident/check/check.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/text.hpp"
#include "ident/check/beside_models.hpp"
#include "ident/check/inquiry.hpp"
#include "ident/check/real_frfs.hpp"
#include "ident/check/repeated_numbers.hpp"
#include "ident/check/virtual_point_check.hpp"
#include "ident/plan/couple_first.hpp"
#include "ident/plan/data_source.hpp"
#include "ident/plan/line_choice.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

constexpr CheckExtent short_form = {.lines = 24, .values = 1'000'000}, long_form = {.lines = static_cast<std::size_t>(-1)};

constexpr std::size_t most_parts_at_once = 16;

/// Runs of the scene's files that are one; none where the files are not to be read.
std::vector<Suspect> equal_runs(const Scene& scene) {
  try {
    return find_equal_runs(scene);
  } catch (const InputError&) {
    return {};  // data in memory
  }
}

CheckResult check_lines(const CheckedSystems& systems, const Dofs& joint, const Control& control, const CheckExtent& most) {
  std::vector<CheckedFile> files = read_checked_files(systems, most, control.interrupted);
  std::vector<Suspect> first = find_real_assemblies(files);
  const bool all_real = are_all_real(files);
  const bool with_axis = most.lines > short_form.lines;
  const auto parts = static_cast<std::size_t>(std::ranges::count(files, false, &CheckedFile::assembly));
  CheckResult result = parts > most_parts_at_once ? inquire_by_parts(files, joint, control, with_axis)
                                                  : inquire(std::move(files), joint, control, with_axis);
  for (Suspect& each : equal_runs(systems.scene)) first.push_back(std::move(each));
  result.suspects.insert(result.suspects.begin(), first.begin(), first.end());
  if (!first.empty()) result.verdict = Verdict::wrong;
  if (all_real) result.notes.insert(result.notes.begin(), std::string(all_frfs_are_real));
  return result;
}

CheckedSystems systems_of(const Plan& plan) { return {plan.scene, *plan.substructures, *plan.assembly, plan.lines}; }

/// The coordinates of all joints of a scene, whether or not the files have them.
Dofs joint_of(const Scene& scene) {
  Dofs all;
  for (const restrictions::JointSpec& joint : scene.joints) {
    for (const frf::Dof& dof : joint.dofs) {
      if (!frf::has(all, dof)) all.push_back(dof);
    }
  }
  return all;
}

}  // namespace

CheckResult check_data(const Plan& plan, const Control& control) {
  return check_lines(systems_of(plan), plan.coordinates.joint, control, long_form);
}

CheckResult quick_check(const Plan& plan, const Control& control) {
  return check_lines(systems_of(plan), plan.coordinates.joint, control, short_form);
}

CheckResult check_systems(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                          std::shared_ptr<frf::FrfSystem> assembly, const Control& control) {
  std::vector<std::string> notes;
  Scene reduced = scene;
  const auto parts = couple_first(reduced, std::move(substructures), notes);
  const std::vector<Line> lines = choose_lines(reduced, *parts, *assembly, notes);
  return check_lines({reduced, *parts, *assembly, lines}, joint_of(reduced), control, long_form);
}

std::string other_causes(const Scene& scene) {
  const auto has = [&](restrictions::Kind kind) {
    return std::ranges::any_of(scene.joints, [&](const restrictions::JointSpec& joint) { return joint.matrices.contains(kind); });
  };
  const auto is_model = [](const DataFile& file) { return models::is_model_file(file.path); };
  std::vector<std::string> causes;
  if (!has(restrictions::Kind::mass)) causes.push_back("mass at the joint ([joint.mass])");
  const bool hysteretic = has(restrictions::Kind::hysteretic_damping), viscous = has(restrictions::Kind::viscous_damping);
  if (!(hysteretic && viscous))
    causes.push_back(hysteretic ? "another damping law (viscous)"
                     : viscous  ? "another damping law (hysteretic)"
                                : "damping of the joint");
  causes.push_back("a joint DOF left out");
  if (scene.data.regenerate.any() || std::ranges::any_of(scene.data.substructures, is_model))
    causes.push_back("missing modes of a model");
  causes.push_back("bolts at another force level or torque than the scene's other files");
  return "Where no file is wrong, look for: " + one_of(causes);
}

CheckResult check_scene(const Scene& scene, const Control& control) {
  OpenedScene opened = open_scene(scene);
  CheckResult result = check_systems(
      scene,
      std::make_shared<frf::FrfSystem>("substructures", std::move(opened.substructures), frf::Composition::uncoupled,
                                       scene.data.reciprocity),
      std::make_shared<frf::FrfSystem>("assembly", std::move(opened.assembly), frf::Composition::merged, scene.data.reciprocity),
      control);
  check_virtual_points(scene, control, result);
  check_beside_models(scene, control, result);
  return result;
}

}  // namespace jointid::ident
