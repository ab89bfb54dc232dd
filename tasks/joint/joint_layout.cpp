#include "tasks/joint/joint_layout.hpp"

#include <algorithm>
#include <map>

#include "frf/text/direction_names.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::tasks {
namespace {

using Springs = std::vector<std::string>;

/// "x", "y", "z", "rx", "ry", "rz".
std::string word(frf::Direction direction) {
  return frf::lower_case(frf::direction_names[static_cast<std::size_t>(direction) - 1]);
}

std::string spring(const NodePair& pair, frf::Direction direction) {
  const frf::Dof first{pair.first, direction}, second{pair.second, direction};
  return "[\"" + first.name() + "\", \"" + second.name() + "\"]";
}

std::string joined(const Springs& springs, const std::string& between) {
  std::string text;
  for (const std::string& each : springs) text += (text.empty() ? "" : between) + each;
  return text;
}

/// A pair a line.
std::string one_by_one(const JointLayout& layout) {
  Springs lines;
  for (const NodePair& pair : layout.pairs) {
    Springs springs;
    for (const frf::Direction direction : pair.directions) springs.push_back(spring(pair, direction));
    if (!springs.empty()) lines.push_back("  " + joined(springs, ", "));
  }
  return lines.empty() ? "" : "[\n" + joined(lines, ",\n") + ",\n]";
}

/// Springs of one name are one unknown. A table in a line: TOML has no other.
std::string by_direction(const JointLayout& layout) {
  std::map<frf::Direction, Springs> springs;
  for (const NodePair& pair : layout.pairs) {
    for (const frf::Direction direction : pair.directions) springs[direction].push_back(spring(pair, direction));
  }
  Springs named;
  for (const auto& [direction, list] : springs) named.push_back(word(direction) + " = [" + joined(list, ", ") + "]");
  return named.empty() ? "" : "{ " + joined(named, ", ") + " }";
}

/// Between the virtual points of a plate, motion by motion.
std::string between_plates() {
  const std::vector<frf::Dof> dofs = plate_dofs();
  Springs lines;
  for (std::size_t i = 0; i < dofs.size() / 2; ++i)
    lines.push_back("  [\"" + dofs[i].name() + "\", \"" + dofs[i + dofs.size() / 2].name() + "\"]");
  return "[\n" + joined(lines, ",\n") + ",\n]";
}

std::size_t unknowns_of_stiffness(const JointLayout& layout) {
  if (layout.form == JointForm::plate) return plate_dofs().size() / 2;
  if (layout.form == JointForm::full) {
    const std::size_t size = dofs_of(layout).size();
    return size * (size + 1) / 2;
  }
  std::size_t springs = 0;
  std::map<frf::Direction, std::size_t> kinds;
  for (const NodePair& pair : layout.pairs) {
    springs += pair.directions.size();
    for (const frf::Direction direction : pair.directions) ++kinds[direction];
  }
  return layout.form == JointForm::springs ? springs : kinds.size();
}

}  // namespace

std::vector<frf::Dof> dofs_of(const JointLayout& layout) {
  if (layout.form == JointForm::plate) return plate_dofs();
  std::vector<frf::Dof> dofs;
  for (const NodePair& pair : layout.pairs) {
    for (const frf::Direction direction : pair.directions) {
      for (const std::int64_t node : {pair.first, pair.second}) {
        if (const frf::Dof dof{node, direction}; !frf::has(dofs, dof)) dofs.push_back(dof);
      }
    }
  }
  std::ranges::sort(dofs, {}, frf::coordinate_key);
  return dofs;
}

std::size_t unknowns_of(const JointLayout& layout) { return unknowns_of_stiffness(layout) * (layout.damping ? 2 : 1); }

std::string springs_text(const JointLayout& layout) {
  if (layout.form == JointForm::full) return "";
  if (layout.form == JointForm::plate) return between_plates();
  return layout.form == JointForm::springs ? one_by_one(layout) : by_direction(layout);
}

}  // namespace jointid::tasks
