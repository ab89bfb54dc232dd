#include "ident/plan/joint_guess.hpp"

#include <cmath>

#include "ident/plan/true_values.hpp"
#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {

std::vector<double> joint_values(const Plan& plan, const std::map<restrictions::Kind, Matrix>& matrices, const std::string& place) {
  const auto known = true_values(plan.restriction, matrices);
  std::vector<double> values;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const std::size_t unknown = plan.columns->unknown_of(column);
    if (!known[unknown] && matrices.contains(plan.restriction.unknowns[unknown].kind)) {
      fail(plan.scene, place, "its matrices do not fix " + plan.columns->name(column, plan.restriction),
           "give matrices that follow the joint's pattern");
    }
    values.push_back(known[unknown].value_or(0.0));
  }
  return values;
}

std::vector<double> joint_guess(const Plan& plan) {
  const Scene& scene = plan.scene;
  const bool truth = !scene.truth.empty();
  const auto& matrices = truth ? scene.truth : scene.identify.start;
  const std::string place = truth ? "[truth]" : "[identify] start";
  if (matrices.empty()) {
    fail(scene, place, "a bound needs a joint to assume, and the scene has neither [truth] nor [identify] start",
         "add [truth] with the matrices you expect");
  }
  return joint_values(plan, matrices, place);
}

std::size_t find_candidate(const Scene& scene, const Dofs& coordinates, const frf::Dof& dof) {
  const std::size_t found = frf::find_coordinate(coordinates, dof);
  if (found != frf::npos) return found;
  const std::string near = nearest_word(dof.name(), frf::names(coordinates));
  fail(scene, "--candidates", dof.name() + " is no coordinate of both the substructures and the assembly",
       near.empty() ? "`jointid plan` lists them" : "did you mean " + near + "?");
}

std::vector<double> scaled(const Plan& plan, const std::vector<double>& values) {
  std::vector<double> theta;
  for (std::size_t column = 0; column < values.size(); ++column) theta.push_back(values[column] / plan.unscale(column));
  return theta;
}

std::vector<double> started(const Plan& plan, const Plan& start, const Control& control) {
  Control quick = control;
  quick.detail = Detail::estimates;
  quick.judgement = Judgement::none;
  quick.so_far = nullptr;
  Solution first;
  start.method->solve(start, quick, first);
  std::vector<double> theta(plan.columns->size(), 0.0);
  for (std::size_t column = 0; column < first.unknowns.size(); ++column) {
    const double value = first.unknowns[column].value;
    if (std::isfinite(value)) theta[column] = value / plan.unscale(column);
  }
  return theta;
}

}  // namespace jointid::ident
