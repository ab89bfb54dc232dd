#pragma once

#include "friction/path/masing_path.hpp"

namespace jointid::response {

/// The force of a joint from step to step: along a Masing path, or of a spring, which has none.
class JointPath {
 public:
  /// `element` must outlive it.
  explicit JointPath(const friction::Element& element);

  /// At q, reached without turning; the joint stays where it is.
  friction::Response response(double q) const { return spring_ ? path_.element().response(q) : path_.response(q); }
  /// The same, and goes there.
  friction::Response advance(double q) { return spring_ ? path_.element().response(q) : path_.advance(q); }

 private:
  friction::MasingPath path_;
  bool spring_;
};

}  // namespace jointid::response
