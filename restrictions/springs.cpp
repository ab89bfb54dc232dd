#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "frf/set/frf_set.hpp"
#include "restrictions/local_matrix.hpp"
#include "restrictions/unit.hpp"

namespace jointid::restrictions {
namespace {

/// One end of a spring in the joint's numbering.
struct End {
  std::size_t index = 0;
  double sign = 1.0;  ///< of the spring's DOF relative to the joint's
};

/// Vector b of a spring: one or two ends.
using Ends = std::vector<End>;

std::string name(const Spring& spring) {
  return "[" + spring.first.name() + "," + (spring.second ? spring.second->name() : "ground") + "]";
}

End end_at(const JointSpec& joint, Kind kind, const Spring& spring, const frf::Dof& dof) {
  const std::size_t index = frf::find_coordinate(joint.dofs, dof);
  if (index == frf::npos) {
    std::vector<std::string> names;
    for (const frf::Dof& known : joint.dofs) names.push_back(known.name());
    const std::string near = nearest_word(dof.name(), names);
    fail(joint, kind, "spring " + name(spring) + ": " + dof.name() + " is not a DOF of the joint",
         near.empty() ? "add it to dofs" : "did you mean " + near + "?");
  }
  return {index, static_cast<double>(dof.sign * joint.dofs[index].sign)};
}

Ends ends_of(const JointSpec& joint, Kind kind, const Spring& spring) {
  Ends ends = {end_at(joint, kind, spring, spring.first)};
  if (!spring.second) return ends;
  if (spring.first.same_coordinate(*spring.second)) {
    fail(joint, kind, "spring " + name(spring) + " has both ends on one DOF",
         "write [\"" + spring.first.name() + "\",\"ground\"] for a spring to ground");
  }
  if (spring.first.is_rotation() != spring.second->is_rotation()) {
    fail(joint, kind, "spring " + name(spring) + " joins a translation and a rotation",
         "write the coupling as a matrix of expressions");
  }
  ends.push_back(end_at(joint, kind, spring, *spring.second));
  ends[1].sign = -ends[1].sign;
  return ends;
}

/// b and −b make the same matrix: both sorted by index, the first sign made positive.
std::vector<std::array<double, 2>> canonical(Ends ends) {
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.index < b.index; });
  std::vector<std::array<double, 2>> key;
  for (const End& end : ends) key.push_back({static_cast<double>(end.index), end.sign * ends[0].sign});
  return key;
}

}  // namespace

LocalMatrix from_springs(const JointSpec& joint, Kind kind, const std::vector<Spring>& springs) {
  if (springs.empty()) fail(joint, kind, "the list of springs is empty", "leave the matrix out if it is zero");
  LocalMatrix matrix;
  std::map<std::vector<std::array<double, 2>>, std::string> seen;
  for (const Spring& spring : springs) {
    const Ends ends = ends_of(joint, kind, spring);
    const auto [same, is_new] = seen.try_emplace(canonical(ends), name(spring));
    if (!is_new) {
      fail(joint, kind, "springs " + same->second + " and " + name(spring) + " are parallel: only their sum acts",
           "keep one of them");
    }
    const frf::Dof& dof = joint.dofs[ends[0].index];
    const std::size_t unknown = matrix.unknowns.size();
    matrix.unknowns.push_back({symbol(kind) + name(spring), unit(kind, dof, dof)});
    for (const End& row : ends) {
      for (const End& column : ends) {
        matrix.terms.push_back({row.index, column.index, unknown, row.sign * column.sign});
      }
    }
  }
  return matrix;
}

}  // namespace jointid::restrictions
