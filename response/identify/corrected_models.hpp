#pragma once

#include <memory>
#include <vector>

#include "response/identify/line_correlation.hpp"

namespace jointid::response {

/// Models of the states over receptances and forces with these errors taken off (CorrectedReceptance), lines as in the layout.
std::vector<StateModel> corrected_models(const std::shared_ptr<const Receptance>& structure,
                                         const std::vector<MeasuredState>& states, const LineLayout& layout,
                                         const LineErrors& errors, const std::vector<int>& harmonics);

/// Errors of one layout in another of the same states: those of harmonics that both have, 0 for the rest.
LineErrors carried(const LineLayout& from, const LineErrors& errors, const LineLayout& to);

/// Σu²
double squared_norm(const LineErrors& errors);

}  // namespace jointid::response
