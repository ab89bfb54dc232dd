#include <array>
#include <charconv>

#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

using restrictions::EntryMatrix;
using restrictions::JointSpec;
using restrictions::Kind;

std::string times(double value, const char* unknown) {
  std::array<char, 32> buffer{};
  return std::string(buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr) + "*" + unknown;
}

EntryMatrix in_shares(const EntryMatrix& numbers, const char* unknown) {
  EntryMatrix out = numbers;
  for (auto& row : out) {
    for (restrictions::Entry& entry : row) {
      if (std::get<double>(entry) != 0.0) entry = times(std::get<double>(entry), unknown);
    }
  }
  return out;
}

/// Of a stiffness by numbers, not all of them 0.
const EntryMatrix* nominal_of(const JointSpec& joint) {
  const auto found = joint.matrices.find(Kind::stiffness);
  const EntryMatrix* matrix = found == joint.matrices.end() ? nullptr : std::get_if<EntryMatrix>(&found->second);
  if (matrix == nullptr) return nullptr;
  bool any = false;
  for (const auto& row : *matrix) {
    for (const restrictions::Entry& entry : row) {
      if (!std::holds_alternative<double>(entry)) return nullptr;
      any = any || std::get<double>(entry) != 0.0;
    }
  }
  return any ? matrix : nullptr;
}

}  // namespace

void make_nominal(const scene::Item& item, std::vector<JointSpec>& joints) {
  for (JointSpec& joint : joints) {
    const EntryMatrix* const nominal = nominal_of(joint);
    if (nominal == nullptr) {
      item.fail(
          "the stiffness of " + (joint.name.empty() ? "the joint" : "joint '" + joint.name + "'") + " is not given by numbers",
          "write its nominal stiffness, stiffness.matrix = [[1e6, -1e6], [-1e6, 1e6]], or leave loose out");
    }
    const EntryMatrix numbers = *nominal;
    joint.matrices[Kind::stiffness] = in_shares(numbers, "share");
    if (!joint.matrices.contains(Kind::hysteretic_damping)) joint.matrices[Kind::hysteretic_damping] = in_shares(numbers, "loss");
  }
}

}  // namespace jointid::ident
