#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "friction/curve/curve.hpp"
#include "friction/law/law.hpp"
#include "friction/path/element.hpp"

namespace jointid::friction {

/// Of loading curves and of loops by Masing's rule: the slope through the origin of what lies below 30 % of the largest force,
/// and that force. Of energies, which end as 4·limit·u, and of equivalents: their first stiffness and last damping.
Features features(const Curve& curve);

/// A law with a way to begin a fit: elements near a curve with such features, differing in what features do not tell.
struct Family {
  std::string name, title;
  std::function<std::vector<std::unique_ptr<Element>>(const Features&)> starts;
};

/// The family of a law by its name. Throws InputError with the valid names.
Family family(const std::string& law);

/// The family of a rotary joint of rings between two radii (m) with a law per area. Throws InputError.
Family ring_family(const std::string& law, double inner, double outer);

/// All laws that a curve can be fitted with by name alone.
std::vector<std::string> fitted_laws();

}  // namespace jointid::friction
