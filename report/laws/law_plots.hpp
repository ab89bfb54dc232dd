#pragma once

#include "report/page/contents.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::report {

/// Of every joint over |Q₁| of all states: k_e and d_e without a law and by the law, and the residuals of the fit.
PlotGroup law_plots(const laws::LawScene& scene, const laws::LawIdentification& found);

}  // namespace jointid::report
