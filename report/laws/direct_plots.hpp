#pragma once

#include "laws/task/direct_identification.hpp"
#include "report/page/contents.hpp"

namespace jointid::report {

/// Of every joint k_e and d_e of all states over |Q₁|, with one deviation above and below.
PlotGroup equivalent_plots(const laws::LawScene& scene, const laws::DirectIdentification& found);

/// Of every joint the measured loops f(q), q = Re Σ Q_n e^{inωt}, f = Re Σ F_n e^{inωt}: of each level that of the largest |Q₁|.
PlotGroup loop_plots(const laws::LawScene& scene, const laws::DirectIdentification& found);

}  // namespace jointid::report
