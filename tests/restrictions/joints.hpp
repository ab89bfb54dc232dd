#pragma once

#include "restrictions/restriction.hpp"

namespace jointid::restrictions {

inline std::vector<frf::Dof> dofs(const std::vector<std::string>& names) {
  std::vector<frf::Dof> result;
  for (const std::string& name : names) result.push_back(frf::Dof::parse(name));
  return result;
}

/// The joint of the thesis' beam: two nodes, each with a deflection and a slope.
inline std::vector<frf::Dof> beam_dofs() { return dofs({"4:+Y", "4:+RZ", "5:+Y", "5:+RZ"}); }

/// A joint without a name with one matrix.
inline JointSpec joint(const std::vector<frf::Dof>& joint_dofs, Kind kind, MatrixSpec spec) {
  return {.name = {}, .dofs = joint_dofs, .matrices = {{kind, std::move(spec)}}, .bands_hz = {}, .node_positions = {}};
}

inline Spring spring(const std::string& first, const std::string& second) {
  return {frf::Dof::parse(first),
          second == "ground" ? std::nullopt : std::optional<frf::Dof>(frf::Dof::parse(second))};
}

inline std::vector<std::string> names(const Restriction& restriction) {
  std::vector<std::string> result;
  for (const Unknown& unknown : restriction.unknowns) result.push_back(unknown.name);
  return result;
}

inline std::vector<std::string> units(const Restriction& restriction) {
  std::vector<std::string> result;
  for (const Unknown& unknown : restriction.unknowns) result.push_back(unknown.unit);
  return result;
}

}  // namespace jointid::restrictions
