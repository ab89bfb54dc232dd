#pragma once

#include <string_view>

/// Files of this folder, put into the program by the build (cmake/JointidEmbed.cmake).
namespace jointid::report::assets {

extern const std::string_view uPlot_iife_min_js, uPlot_min_css, LICENSE;  ///< the plotting library uPlot
extern const std::string_view page_css;
extern const std::string_view errors_js;  ///< before all else: counts errors
extern const std::string_view look_js, plots_js, touch_js, page_js, selfcheck_js;

}  // namespace jointid::report::assets
