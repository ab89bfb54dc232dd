#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "friction/curve/curve.hpp"

namespace jointid::friction {

/// u(h) of a law: the displacement at which the share h of its initial stiffness has slipped, T′(u) = T′(0)(1 − h) (Ren 2.53, 2.57).
/// At a kink the kink itself. +infinity where no u has so small a slope. Throws InputError (usage) unless 0 ≤ h < 1.
double slip_displacement(const Element& law, double share);

/// A form of u(h), fitted by least squares of u.
struct SlipForm {
  std::string law;                ///< the law that has it: "ren" a·exp(bh), "exponential-offset" a·exp(bh) + c, "power" a + b·hᶜ,
                                  ///< "square" a + b·h², "shoukry" −ln(1 − h)/b
  std::vector<double> parameters;  ///< a, b, c as far as it has them; of shoukry b
  double rms = 0.0;                ///< of u − u(h), over the largest u
};

/// The first step from a curve to a law: h = 1 − T′/k from the slopes of a loading curve.
struct SlipShares {
  double stiffness = 0.0;       ///< k: the largest slope, or as given
  std::vector<double> u, h;     ///< by displacement
  std::vector<SlipForm> forms;  ///< the best first
};

struct SlipShareOptions {
  std::size_t points = 5;               ///< of each slope, ≥ 2: those of noisy curves need more
  std::optional<double> stiffness = {};  ///< k > 0; empty: the largest slope
};

/// Slopes by least squares over `points` neighbouring samples. A slope above k has h < 0, which noise gives; forms are fitted to
/// 0.02 < h < 0.98. Throws InputError (usage) where the curve is no loading curve, has too few samples or no share in that range.
SlipShares slip_shares(const Curve& curve, const SlipShareOptions& options = {});

}  // namespace jointid::friction
