#pragma once

#include "tasks/loading_curve/loading_curve_result.hpp"
#include "report/text/table.hpp"

/// Tables of `jointid loading-curve` on the terminal and in its report.
namespace jointid::report {

/// One row per law: AIC and how far it is from the best one, residuals, limit and initial stiffness.
Table laws_table(const tasks::LoadingCurveResult& result);

/// Parameters of a fit with intervals, and what follows from them; curve by curve where elements differ.
Table parameters_table(const tasks::LoadingCurveResult& result, const friction::Fit& fit);

/// Of loops fitted one by one: smallest, median and largest limit, stiffness and energy error of each law.
Table loops_table(const tasks::LoadingCurveResult& result);

/// The forms of u(h), the best first.
Table slip_forms_table(const friction::SlipShares& shares);

/// Equivalents of an element over amplitude.
Table equivalents_table(const friction::CurveFit& fit, std::size_t count);

}  // namespace jointid::report
