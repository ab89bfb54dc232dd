#pragma once

#include <cstdint>

namespace jointid::frf {

/// Nodes that are no points of a structure: coordinates of a whole interface (folder virtualpoint). Their numbers are below 0,
/// where no measured node is, and their names VP1 (rigid motion), VP1E (extensions and torsions), VP1S (skewings).
enum class VirtualNode : std::uint8_t { rigid, extension, skewing };

inline constexpr std::int64_t largest_virtual_point = 999'999;

/// The node of virtual point 1 to largest_virtual_point.
constexpr std::int64_t virtual_node(std::int64_t point, VirtualNode kind) {
  return -(static_cast<std::int64_t>(kind) * (largest_virtual_point + 1) + point);
}

constexpr bool is_virtual(std::int64_t node) { return node < 0; }
constexpr std::int64_t point_of(std::int64_t node) { return -node % (largest_virtual_point + 1); }
constexpr VirtualNode kind_of(std::int64_t node) { return static_cast<VirtualNode>(-node / (largest_virtual_point + 1)); }

}  // namespace jointid::frf
