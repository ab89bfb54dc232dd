#pragma once

#include <functional>

#include "gui/plot/curve.hpp"

namespace jointid::gui {

/// What many FRFs say together, per file: the sum of their magnitudes, or the first three singular values of their matrix
/// (report/mode_indicators.hpp; FRFs that were not chosen count as 0). FRFs with another unit than the first of their file are
/// left out, and the name says of how many FRFs it is. Other views: the curves as they are. Throws Interrupted.
std::vector<Curve> indicators(std::vector<Curve> curves, View view, const std::function<bool()>& interrupted);

}  // namespace jointid::gui
