#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// Bilinear elements in parallel, and a spring: T(u) = rest·u + Σ stiffness_i min(u, slip_i).
struct Sliders {
  std::vector<double> slip;
  std::vector<double> stiffness;
  double rest = 0.0;
};

/// The polygon through (u_i, T(u_i)) of a law as sliders, u_i being the increasing `knots` > 0. Where T still rises at the last
/// knot, it goes on as a straight line. The difference to T is below T″Δu²/8.
Sliders sliders(const Element& element, std::span<const double> knots);

/// `count` knots up to `largest` (or up to macroslip when that is less), put where the polygon is farthest from T. The largest
/// difference falls with count⁻².
std::vector<double> slip_knots(const Element& element, std::size_t count, double largest);

/// `count` sliders of equal stiffness T′(0)/count that slip at u(h), h = (i − ½)/count: T′(u(h)) = T′(0)(1 − h) (Ren 3.56). Those
/// of a law without a limit that never slip are `rest`. The difference to T falls with count⁻².
Sliders even_sliders(const Element& element, std::size_t count);

/// The sliders as an element.
std::unique_ptr<Element> bilinear_assembly(const Sliders& sliders);

}  // namespace jointid::friction
