#pragma once

#include <string>

#include "cli/report/contents.hpp"

namespace jointid::cli::report {

/// A plot group as the page's program reads it (plots.js). Numbers have six significant digits, on x-axes nine; NaN is null.
std::string plot_json(const PlotGroup& group);

}  // namespace jointid::cli::report
