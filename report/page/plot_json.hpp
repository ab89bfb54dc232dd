#pragma once

#include <string>

#include "report/page/contents.hpp"

namespace jointid::report {

/// A plot group as the page's program reads it (plots.js). Numbers have six significant digits, on x-axes nine; NaN is null.
std::string plot_json(const PlotGroup& group);

}  // namespace jointid::report
