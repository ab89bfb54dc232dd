#pragma once

#include "report/page/contents.hpp"
#include "report/text/display.hpp"
#include "tasks/couple/couple_frfs.hpp"

/// The plots of a couple report; curves of more than `most` points are thinned, peaks kept.
namespace jointid::report {

/// Magnitude and phase, one choice per FRF. With variances the 95 % interval of the magnitude, |H| exp(±1.96 s/|H|) where
/// s² = (x²v_x + y²v_y)/|H|² for H = x + iy: to first order in ln|H|, so that it never reaches zero. With `bounds` the FRF with
/// all conditions; what was measured behind it.
PlotGroup predicted_plots(const std::vector<double>& frequency_hz, const std::vector<tasks::PredictedFrf>& frfs, std::size_t most,
                          const Display& display = {});

/// Condition of S over the lines; with a threshold how many conditions were kept, and its singular values and what the first that
/// was dropped had to exceed.
PlotGroup condition_plots(const tasks::CoupleResult& result, std::size_t most);

/// The alphas of some conditions over the lines and what they are compared with, twelve conditions together. Empty when the lines
/// have none.
PlotGroup alpha_plots(const std::vector<double>& frequency_hz, const std::vector<coupling::LineRecord>& lines,
                      const std::vector<std::string>& conditions, std::optional<double> level, std::size_t most);

}  // namespace jointid::report
