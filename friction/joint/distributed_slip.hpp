#pragma once

#include <vector>

#include "friction/law/sliders.hpp"
#include "friction/path/element.hpp"

namespace jointid::friction {

/// Force along any history from the shear stress of every slider, algorithm A of docs/formulas.md §10b: constant memory however
/// long the history, and the normal load may change. Exact for its sliders, an approximation of the law that they stand for.
class DistributedSlip {
 public:
  explicit DistributedSlip(Sliders sliders);

  /// Force and tangent at displacement u and `load` = normal load over the one that the law belongs to (slip limits are
  /// proportional to it, stiffnesses are not; below 0 as 0). First all sliders deform elastically, then their forces are cut to
  /// the limits of this load (3.58, 3.59): steps must be small where u and load change together.
  Response advance(double u, double load = 1.0);

  /// The same without going there.
  Response response(double u, double load = 1.0) const;

  double displacement() const { return displacement_; }
  double stored() const;                 ///< elastic energy, J
  double loss() const { return loss_; }  ///< energy turned into heat, J; exact while the load is constant

 private:
  Sliders sliders_;
  std::vector<double> force_;  ///< of each slider
  double displacement_ = 0.0;
  double loss_ = 0.0;
};

}  // namespace jointid::friction
