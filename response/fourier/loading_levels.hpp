#pragma once

#include <vector>

#include "friction/path/element.hpp"

namespace jointid::response {

/// Displacements where an integral along T(u) is split so that Gauss's rule converges in every piece: the kinks of the law, and a
/// geometric row from where the tangent has fallen to half its value at 0 to where it is negligible.
class LoadingLevels {
 public:
  explicit LoadingLevels(const friction::Element& element);

  /// Those strictly between two displacements, ascending. Below the row it goes on geometrically from `from` > 0.
  std::vector<double> between(double from, double to) const;

  /// Displacement over which the tangent falls; +infinity for a linear law.
  double scale() const { return scale_; }

 private:
  double scale_;
  std::vector<double> levels_;
};

}  // namespace jointid::response
