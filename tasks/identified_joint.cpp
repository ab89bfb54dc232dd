#include "tasks/identified_joint.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/set/frf_set.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/likelihood/findings/joint_errors.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::tasks {
namespace {

using restrictions::Kind;

constexpr double same_line = 1e-6;  ///< relative difference of frequencies of one line

[[noreturn]] void fail(const ident::Scene& scene, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = scene.file.string(),
                    .place = "[[couple.joint]] identified",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

std::vector<double> values_of(const ident::Solution& solution) {
  std::vector<double> out;
  for (const ident::Estimate& unknown : solution.unknowns) out.push_back(unknown.value);
  return out;
}

/// What a matrix gains by one of an unknown.
std::vector<double> derivative(const restrictions::Restriction& restriction, Kind kind, std::size_t unknown) {
  std::vector<double> y(restriction.unknowns.size(), 0.0);
  const std::vector<double> before = restriction.matrix(kind, y);
  y[unknown] = 1.0;
  std::vector<double> out = restriction.matrix(kind, y);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] -= before[i];
  return out;
}

/// What the errors of an FRF of a part have in common with the joint's, looked up by names and frequency.
class Common {
 public:
  Common(ident::JointErrors errors, std::vector<std::string> shared) : errors_(std::move(errors)), shared_(std::move(shared)) {}

  std::vector<Complex> operator()(const std::string& part, const frf::Dof& row, const frf::Dof& column, double hz) const {
    if (std::ranges::find(shared_, part) == shared_.end()) return {};
    const std::size_t r = frf::find_coordinate(errors_.coordinates, row), c = frf::find_coordinate(errors_.coordinates, column);
    const auto line = std::ranges::lower_bound(errors_.frequency_hz, hz * (1.0 - same_line));
    if (r == frf::npos || c == frf::npos || line == errors_.frequency_hz.end() || *line > hz * (1.0 + same_line)) return {};
    const double sign = row.sign * column.sign * errors_.coordinates[r].sign * errors_.coordinates[c].sign;
    const auto first = errors_.common[static_cast<std::size_t>(line - errors_.frequency_hz.begin())].begin() +
                       static_cast<std::ptrdiff_t>(frf::pair_index(std::max(r, c), std::min(r, c)) * errors_.unknowns());
    std::vector<Complex> out(first, first + static_cast<std::ptrdiff_t>(errors_.unknowns()));
    for (Complex& value : out) value *= sign;
    return out;
  }

 private:
  ident::JointErrors errors_;
  std::vector<std::string> shared_;
};

}  // namespace

coupling::KnownJoint identified_joint(const ident::Plan& plan, const ident::Solution& solution, std::vector<coupling::PlacedDof> dofs,
                                      const std::vector<std::string>& shared, bool uncertainty, const ident::Control& control) {
  if (solution.bands.size() != 1) fail(plan.scene, "its joint has bands, and so no one matrix", "identify one without bands");
  coupling::KnownJoint joint;
  if (dofs.empty()) {
    for (const frf::Dof& dof : solution.dofs) dofs.push_back({{}, dof});
  }
  if (dofs.size() != solution.dofs.size()) {
    fail(plan.scene, "its joint has " + std::to_string(solution.dofs.size()) + " DOFs, and " + std::to_string(dofs.size()) + " are named",
         "name them in the order of that scene, or leave dofs out");
  }
  joint.dofs = std::move(dofs);
  const restrictions::Restriction& restriction = plan.restriction;
  const std::vector<double> values = values_of(solution);
  joint.stiffness = restriction.matrix(Kind::stiffness, values);
  joint.mass = restriction.matrix(Kind::mass, values);
  joint.viscous_damping = restriction.matrix(Kind::viscous_damping, values);
  joint.hysteretic_damping = restriction.matrix(Kind::hysteretic_damping, values);
  if (!uncertainty) return joint;
  ident::JointErrors errors = ident::joint_errors(plan, values, control);
  auto of = std::make_shared<coupling::JointUncertainty>();
  for (std::size_t m = 0; m < values.size(); ++m) {
    of->unknowns.push_back({derivative(restriction, Kind::stiffness, m), derivative(restriction, Kind::mass, m),
                            derivative(restriction, Kind::viscous_damping, m), derivative(restriction, Kind::hysteretic_damping, m)});
  }
  of->covariance.assign(errors.covariance.data(), errors.covariance.data() + errors.covariance.size());
  of->common = Common(std::move(errors), shared);
  joint.uncertainty = std::move(of);
  return joint;
}

FoundJoint identify_joint(const ident::CoupleScene& scene, const ident::IdentifiedJoint& joint, const ident::Control& control) {
  const ident::Scene identification = ident::read_scene(joint.scene);
  const auto plan = ident::make_plan(identification);
  if (scene.options.uncertainty) ident::require_joint_errors(*plan);  // before it is solved for nothing
  const ident::Solution solution = ident::solve(*plan, control);
  if (!ident::is_usable(solution.status)) {
    fail(plan->scene, "it has no usable solution (" + ident::name(solution.status) + "): " + solution.message,
         "see `jointid solve` of it, or give the matrices in numbers");
  }
  std::vector<std::string> shared;
  const auto same = [](const ident::DataFile& a, const ident::DataFile& b) {
    return std::filesystem::weakly_canonical(a.path) == std::filesystem::weakly_canonical(b.path);
  };
  for (std::size_t part = 0; part < scene.parts.size(); ++part) {
    const auto is_this = [&](const ident::DataFile& file) { return same(file, scene.parts[part]); };
    if (std::ranges::any_of(identification.data.substructures, is_this)) shared.push_back(scene.names[part]);
  }
  std::string note = "The joint is that of " + joint.scene.filename().string() + ", status " + ident::name(solution.status) + ".";
  if (scene.options.uncertainty) {
    note += shared.empty() ? " Its errors are carried; it was found from other FRFs than those of these parts."
                           : " Its errors are carried, with what they share with those of " + comma_list(shared) + ".";
  }
  return {identified_joint(*plan, solution, joint.dofs, shared, scene.options.uncertainty, control), std::move(note)};
}

}  // namespace jointid::tasks
