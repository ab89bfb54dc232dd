#include "tasks/joint/joint_springs.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/statistics.hpp"

namespace jointid::tasks {
namespace {

constexpr double loose_share = 0.5;

using Ends = std::vector<std::array<frf::Dof, 2>>;

/// What an unknown adds to K, row by row.
std::vector<double> stencil(const restrictions::Restriction& restriction, std::size_t unknown) {
  std::vector<double> y(restriction.unknowns.size(), 0.0);
  const std::vector<double> before = restriction.matrix(restrictions::Kind::stiffness, y);
  y[unknown] = 1.0;
  std::vector<double> out = restriction.matrix(restrictions::Kind::stiffness, y);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] -= before[i];
  return out;
}

/// Between which DOFs a stencil is that of springs; none where it is not.
Ends ends_of(const restrictions::Restriction& restriction, const std::vector<double>& k) {
  const std::size_t n = restriction.dofs.size();
  Ends out;
  for (std::size_t i = 0; i < n; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      sum += k[i * n + j];
      if (i == j || k[i * n + j] == 0.0) continue;
      if (k[i * n + j] > 0.0) return {};
      if (i < j) out.push_back({restriction.dofs[i], restriction.dofs[j]});
    }
    if (std::abs(sum) > 1e-9) return {};
  }
  return out;
}

const ident::Estimate* estimate_of(const ident::Solution& solution, const std::string& name) {
  const auto found = std::ranges::find(solution.unknowns, name, &ident::Estimate::name);
  return found == solution.unknowns.end() ? nullptr : &*found;
}

/// The unknown of the hysteretic damping with the name of one of the stiffness: "left.D[1:+X,2:+X]" of "left.K[1:+X,2:+X]".
std::optional<double> damping_beside(const ident::Solution& solution, const std::string& stiffness) {
  std::string name = stiffness;
  std::size_t place = name.find("K[");
  if (place == std::string::npos) place = name.find("K.");
  if (place == std::string::npos) return std::nullopt;
  name[place] = 'D';
  const ident::Estimate* const damping = estimate_of(solution, name);
  return damping != nullptr && damping->determined ? std::optional(damping->value) : std::nullopt;
}

void judge_spring(JointSpring& spring, double usual) {
  if (!(std::abs(usual) > 0.0)) return;
  spring.share = spring.stiffness / usual;
  if (spring.half_width) spring.share_half_width = *spring.half_width / std::abs(usual);
  if (!(spring.share < loose_share)) return;
  const bool sure = spring.share_half_width && spring.share + *spring.share_half_width < loose_share;
  spring.tightness = sure ? Tightness::loose : Tightness::doubtful;
}

}  // namespace

std::optional<double> half_width(const ident::Estimate& estimate) {
  if (estimate.ci95) return ((*estimate.ci95)[1] - (*estimate.ci95)[0]) / 2.0;
  return estimate.error_estimate;
}

std::vector<JointSpring> joint_springs(const restrictions::Restriction& restriction, const ident::Solution& solution) {
  std::vector<JointSpring> out;
  for (std::size_t i = 0; i < restriction.unknowns.size(); ++i) {
    const restrictions::Unknown& unknown = restriction.unknowns[i];
    const ident::Estimate* const found = unknown.kind == restrictions::Kind::stiffness ? estimate_of(solution, unknown.name) : nullptr;
    if (found == nullptr || !found->determined || !std::isfinite(found->value)) continue;
    JointSpring spring{.unknown = unknown.name, .ends = ends_of(restriction, stencil(restriction, i)), .stiffness = found->value,
                       .half_width = half_width(*found), .share = 1.0, .share_half_width = {}, .loss_factor = {},
                       .tightness = Tightness::alike};
    if (spring.ends.empty()) continue;
    const auto damping = damping_beside(solution, unknown.name);
    if (damping && std::abs(spring.stiffness) > 0.0) spring.loss_factor = *damping / spring.stiffness;
    out.push_back(std::move(spring));
  }
  std::map<frf::Direction, std::vector<double>> by_direction;
  for (const JointSpring& spring : out) by_direction[spring.ends.front()[0].direction].push_back(spring.stiffness);
  for (JointSpring& spring : out) judge_spring(spring, median(by_direction.at(spring.ends.front()[0].direction)));
  return out;
}

}  // namespace jointid::tasks
