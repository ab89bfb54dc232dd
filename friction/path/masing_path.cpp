#include "friction/path/masing_path.hpp"

#include <cmath>

namespace jointid::friction {

/// With one corner left the branch meets the initial curve on the other side, with more the last corner but one.
double MasingPath::closure(std::size_t open, int direction) const {
  if (open == 0) return direction * infinity;
  return open == 1 ? -corner(0).displacement : corner(open - 2).displacement;
}

/// Corners that are still open at u, the present point being one when the path turns there.
std::size_t MasingPath::open_corners(double u, int direction) const {
  std::size_t open = corners_.size() + (turns(direction) ? 1 : 0);
  while (open > 0 && direction * (u - closure(open, direction)) >= 0.0) open -= open == 1 ? 1 : 2;
  return open;
}

Response MasingPath::on_branch(double u, std::size_t open, int direction) const {
  if (open == 0) {
    const Response initial = element_->response(std::abs(u));
    return {direction * initial.force, initial.tangent};
  }
  const Corner from = corner(open - 1);
  const Response half = element_->response(0.5 * std::abs(u - from.displacement));
  return {from.force + 2.0 * direction * half.force, half.tangent};
}

Response MasingPath::response(double u) const {
  const int direction = u > now_.displacement ? 1 : u < now_.displacement ? -1 : direction_;
  return on_branch(u, open_corners(u, direction), direction);
}

Response MasingPath::advance(double u) {
  if (u == now_.displacement) return response(u);
  const int direction = u > now_.displacement ? 1 : -1;
  const std::size_t open = open_corners(u, direction);
  const Response at = on_branch(u, open, direction);
  if (open > corners_.size()) {
    corners_.push_back(now_);
  } else {
    corners_.resize(open);
  }
  now_ = {u, at.force};
  direction_ = direction;
  return at;
}

Branch MasingPath::branch(int direction) const {
  const std::size_t open = open_corners(now_.displacement, direction);
  if (open == 0) return {{}, true, closure(0, direction)};
  return {corner(open - 1), false, closure(open, direction)};
}

}  // namespace jointid::friction
