#pragma once

#include <memory>

#include "response/fourier/force_harmonics.hpp"
#include "response/fourier/loading_levels.hpp"
#include "response/fourier/motion.hpp"

namespace jointid::response {

/// Fourier integrals of the force of an element that obeys Masing's rule under a periodic motion, event-exact: the path is split
/// at reversals, kinks of the law and closings of loops, and nothing is sampled between them. The state is the one without
/// residual force: on the initial curve at the largest |q| of the period. A motion that does not turn sees T′(0).
class MasingFourier {
 public:
  explicit MasingFourier(std::shared_ptr<const friction::Element> element);

  /// F_n for the harmonics of the force, with derivatives by the motion's unknowns and, if asked for, by the law's parameters.
  ForceHarmonics evaluate(const Motion& motion, const Harmonics& force, bool with_parameters = false) const;

 private:
  std::shared_ptr<const friction::Element> element_;
  LoadingLevels levels_;
};

}  // namespace jointid::response
