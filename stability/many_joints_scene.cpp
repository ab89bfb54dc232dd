#include "stability/many_joints_scene.hpp"

#include <cmath>
#include <map>
#include <tuple>

#include "problems/case/in_memory.hpp"
#include "problems/case/many_joints_problem.hpp"
#include "restrictions/unit.hpp"

namespace jointid::stability {
namespace {

problems::ManyJoints structure_of(const ManyJointsScene& scene) {
  problems::ManyJoints out = scene.frame ? problems::frame_of_beams({.columns = 3, .rows = 3, .legs = 3, .spacing = 3})
                                         : problems::chain_of_beams({.joints = 26});
  const std::size_t joints = out.joints.size(), last = joints - 1;
  constexpr std::size_t stride = 11;  // no divisor of either number of joints
  for (std::size_t e = 0; e < joints; ++e) {
    const double place = static_cast<double>(stride * e % joints) / static_cast<double>(last);
    const double factor = std::pow(scene.spread, 2.0 * place - 1.0);
    const double loss = scene.definite && e % 2 == 1 ? 0.0 : 1.0;
    for (auto& row : out.joints[e].relative_stiffness) {
      for (double& element : row) element *= factor;
    }
    for (auto& row : out.joints[e].relative_damping) {
      for (double& element : row) element *= factor * loss;
    }
  }
  return out;
}

/// Which unknowns can be compared in size: those of one joint between coordinates of the same kinds.
std::vector<std::size_t> groups_of(const ident::Plan& plan) {
  std::vector<std::size_t> out(plan.restriction.unknowns.size(), 0);
  std::map<std::pair<std::size_t, int>, std::size_t> number;
  for (const restrictions::MatrixTerms& matrix : plan.restriction.matrices) {
    for (const restrictions::Term& term : matrix.terms) {
      const int power = restrictions::length_power(plan.restriction.dofs[term.row], plan.restriction.dofs[term.column]);
      out[term.unknown] = number.try_emplace({plan.restriction.unknowns[term.unknown].joint, power}, number.size()).first->second;
    }
  }
  return out;
}

}  // namespace

ExtremeProblem make(const ManyJointsScene& given) {
  problems::Problem problem = problems::many_joints_problem(structure_of(given), {given.frame ? "frame" : "chain", ""}, false);
  ExtremeProblem out;
  out.scene = problems::scene(problem);
  for (restrictions::JointSpec& joint : out.scene.joints) {
    if (given.definite) joint.definite = {restrictions::Kind::stiffness, restrictions::Kind::hysteretic_damping};
  }
  for (const problems::ExactUnknown& unknown : problem.unknowns) out.truth.push_back(unknown.value);
  out.sets = {std::move(problem.substructures), {std::move(problem.assembly)}};
  out.group = groups_of(*out.plan(ident::Solver::automatic));
  return out;
}

}  // namespace jointid::stability
