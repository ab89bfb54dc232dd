#pragma once

#include <map>
#include <optional>
#include <vector>

#include "ident/scene/scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// The value of each unknown that the exact matrices give, found element by element: one with a single unknown left fixes it.
/// Empty where no element does, and where the elements an unknown stands in contradict each other by more than 1e-9 of the
/// matrix's largest element.
std::vector<std::optional<double>> true_values(const restrictions::Restriction& restriction,
                                               const std::map<restrictions::Kind, Matrix>& truth);

}  // namespace jointid::ident
