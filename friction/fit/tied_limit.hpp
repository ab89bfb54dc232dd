#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// ∂limit/∂p of an element with a finite limit.
std::vector<double> limit_derivative(const Element& element);

/// ∂(dT/du(0))/∂p, from a displacement so small beside `largest` that no slip matters.
std::vector<double> stiffness_derivative(const Element& element, double largest);

/// The parameter that a preset limit determines from the others: the one by which the limit changes most nearly in proportion,
/// `spared` ones only when there is no other. Nothing when the limit is infinite.
std::optional<std::size_t> tied_parameter(const Element& element, const std::vector<bool>& spared);

/// The element with `parameter` changed so that its limit is `limit`; null when no value does it.
std::unique_ptr<Element> with_limit(const Element& element, std::size_t parameter, double limit);

}  // namespace jointid::friction
