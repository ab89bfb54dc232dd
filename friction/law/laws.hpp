#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "friction/law/law.hpp"

namespace jointid::friction {

/// The laws that are tried where none is named, in the order of the documentation.
std::span<const Law> laws();

/// Further laws, which have to be named: other u(h), Menq's bar, the bending root.
std::span<const Law> named_laws();

/// The law of that name, of either list, or an arrangement of laws: "series:ren:spring", "parallel:bilinear:ren". Throws
/// InputError with the valid names.
const Law& law(std::string_view name);

/// The same, if a fit can find its parameters. Throws InputError, which names the law to fit in its place: curves and responses
/// do not tell all dimensions of a bar.
const Law& law_to_fit(std::string_view name);

/// The law of that name with these parameter values. Throws InputError.
std::unique_ptr<Element> make_element(std::string_view name, std::span<const double> values);

}  // namespace jointid::friction
