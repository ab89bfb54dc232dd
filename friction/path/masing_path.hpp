#pragma once

#include <cstddef>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// Where the path turned.
struct Corner {
  double displacement = 0.0;
  double force = 0.0;
};

/// The curve that a path follows until it closes a loop: from the corner on, force = corner.force ± 2T(|u − corner.u|/2);
/// on the initial curve ±T(|u|).
struct Branch {
  Corner corner;
  bool initial = true;
  double closure = 0.0;  ///< displacement where it joins an outer branch; ±infinity when it does not
};

/// Force along any displacement history by Masing's rule (2.7, 2.8) with the memory of corner points, algorithm B of
/// docs/formulas.md §10b.
/// Exact: nested loops close, and what lies inside a closed loop is forgotten. The history starts at u = 0 without force.
class MasingPath {
 public:
  /// `element` must outlive the path.
  explicit MasingPath(const Element& element) : element_(&element) {}

  /// Force and dF/du at u, reached without turning on the way; the path itself stays where it is. At the present
  /// displacement the tangent is that of going on in the same direction.
  Response response(double u) const;

  /// The same, and goes there.
  Response advance(double u);

  /// The curve on which the path goes on in this direction, +1 or −1.
  Branch branch(int direction) const;

  const Element& element() const { return *element_; }
  double displacement() const { return now_.displacement; }
  double force() const { return now_.force; }

  /// +1 or −1, the sign of the last motion; 0 before the first.
  int direction() const { return direction_; }

  /// Open corners, outermost first.
  const std::vector<Corner>& corners() const { return corners_; }

 private:
  bool turns(int direction) const { return direction_ != 0 && direction != direction_; }
  Corner corner(std::size_t i) const { return i < corners_.size() ? corners_[i] : now_; }
  double closure(std::size_t open, int direction) const;
  std::size_t open_corners(double u, int direction) const;
  Response on_branch(double u, std::size_t open, int direction) const;

  const Element* element_;
  std::vector<Corner> corners_;
  Corner now_;
  int direction_ = 0;
};

}  // namespace jointid::friction
