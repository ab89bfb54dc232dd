#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// Translation along or rotation about a global axis; the order is that of the codes 1–6 of UFF dataset 58.
enum class Direction : std::uint8_t { x = 1, y, z, rx, ry, rz };

/// A degree of freedom, written `node:direction` with directions ±X ±Y ±Z ±RX ±RY ±RZ, e.g. `4:+Y`, `4:-RZ`.
/// A minus sign means that the transducer pointed the other way: it flips the sign of the FRF.
struct Dof {
  std::int64_t node = 0;
  Direction direction = Direction::x;
  int sign = +1;  ///< +1 or -1

  /// Parses `node:direction`; a missing sign is +. Throws InputError naming the text.
  static Dof parse(std::string_view text);

  std::string name() const;
  bool is_rotation() const { return direction >= Direction::rx; }

  /// Same node and direction, whatever the sign.
  bool same_coordinate(const Dof& other) const {
    return node == other.node && direction == other.direction;
  }
  bool operator==(const Dof&) const = default;
};

/// "4:+Y", "5:-RZ", …
std::vector<std::string> names(const std::vector<Dof>& dofs);

/// Key that orders DOFs by node, then direction, and ignores the sign.
inline std::int64_t coordinate_key(const Dof& dof) { return dof.node * 8 + static_cast<int>(dof.direction); }

}  // namespace jointid::frf
