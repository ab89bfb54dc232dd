#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/complex.hpp"
#include "frf/set/frf_set.hpp"

namespace jointid::frf {

/// Looks for driving points that are not passive: their receptance has an imaginary part above 0. It may hold conjugates, of
/// exp(−iωt), or force and motion may be positive in opposite directions.
class TurnedPoints {
 public:
  explicit TurnedPoints(const FrfHeader& header);

  /// Receptances of whole lines, lines × responses × references.
  void add(std::span<const Complex> values);

  /// The driving points whose imaginary parts are above 0 by a hundred times what is below, in absolute values summed over the
  /// lines.
  std::vector<Dof> found() const;

 private:
  struct Point {
    std::size_t entry = 0;
    Dof dof;
    double sign = 1.0, above = 0.0, below = 0.0;
  };
  std::size_t entries_ = 0;
  std::vector<Point> points_;
};

/// A sentence about them; empty where there are none.
std::string turned_points_text(const std::vector<Dof>& found);

}  // namespace jointid::frf
