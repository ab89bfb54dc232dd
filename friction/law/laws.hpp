#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "friction/law/law.hpp"

namespace jointid::friction {

/// All laws that make_element knows, in the order of the documentation.
std::span<const Law> laws();

/// The law of that name. Throws InputError with the valid names.
const Law& law(std::string_view name);

/// The law of that name with these parameter values. Throws InputError.
std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values);

}  // namespace jointid::friction
