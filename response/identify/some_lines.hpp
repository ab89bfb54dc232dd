#pragma once

#include <vector>

#include "response/identify/measured_state.hpp"

namespace jointid::response {

inline constexpr std::size_t lines_for_a_start = 20;

/// States of so many lines, evenly among all of them: of as many stretches of lines the one at this share of each. Nothing where
/// there are fewer than twice as many lines.
std::vector<MeasuredState> some_lines(const std::vector<MeasuredState>& states, std::size_t count, double share = 0.5);

}  // namespace jointid::response
