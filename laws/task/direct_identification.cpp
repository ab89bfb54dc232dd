#include "laws/task/direct_identification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "laws/task/contradiction.hpp"
#include "response/fourier/harmonics.hpp"

namespace jointid::laws {
namespace {

constexpr double known_share = 0.3;

std::size_t known_states(const std::vector<response::DirectStep>& steps, Eigen::Index joint) {
  const auto count = std::ranges::count_if(steps, [joint](const response::DirectStep& step) {
    return step.equivalent.size() > 0 &&
           std::abs(step.equivalent_deviation(joint)) < known_share * std::abs(step.equivalent(joint));
  });
  return static_cast<std::size_t>(count);
}

/// Standard deviation of |Q₁| in parts of it, in the middle of all states.
double motion_error(const std::vector<response::DirectStep>& steps, Eigen::Index joint) {
  std::vector<double> shares;
  for (const response::DirectStep& step : steps) {
    const Eigen::Index first = response::Harmonics(step.harmonics).find(1);
    if (first >= 0) shares.push_back(std::abs(step.motion_deviation(first, joint) / step.joint_motion(first, joint)));
  }
  return shares.empty() ? nan : median(std::move(shares));
}

void judge_joint(const LawScene& scene, std::size_t j, DirectIdentification& found) {
  if (found.known[j] > 0) return;
  const std::string what =
      fmt::format("{}: no state determines its stiffness to {:.0f} %; its motion Q₁ is known to {:.0f} % in the middle of all states",
                  scene.joints[j].beside.name, 100.0 * known_share, 100.0 * motion_error(found.steps, at(j)));
  const std::string remedy =
      ": Q = b − GF is a difference of like numbers where the parts move far more than the joint, or no response sees its force";
  if (found.status == Status::ok) {
    found.status = Status::doubtful;
    found.message = what + remedy;
  }
  found.notes.push_back(what + remedy);
}

}  // namespace

DirectIdentification identify_directly(const LawScene& scene) {
  DirectIdentification found;
  require_measured(scene);
  found.data = read_level_states(scene);
  found.notes = found.data.notes;
  found.steps = direct_steps(found.data);
  found.consistency = response::test_consistency(*found.data.structure, found.data.states, found.data.level);
  if (found.consistency.contradicts()) {
    found.status = Status::poor_fit;
    found.message = contradiction_text(found.consistency, found.data.responses, level_names(scene));
  }
  found.one_sided = test_even_harmonics(found.steps, found.data.structure->joints());
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    found.known.push_back(known_states(found.steps, at(j)));
    judge_joint(scene, j, found);
    if (!found.one_sided[j].is_told()) continue;
    found.notes.push_back(one_sided_text(found.one_sided[j], scene.joints[j].beside.name));
    if (found.status != Status::ok) continue;
    found.status = Status::doubtful;
    found.message = found.notes.back();
  }
  return found;
}

}  // namespace jointid::laws
