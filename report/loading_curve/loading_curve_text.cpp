#include "report/loading_curve/loading_curve_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/loading_curve/loading_curve_tables.hpp"
#include "tasks/loading_curve/loading_curve_result.hpp"

namespace jointid::report {
namespace {

std::string curves_text(const tasks::LoadingCurveResult& result) {
  std::string text = result.title + "\n";
  for (const std::string& note : result.data.notes) text += "  " + note + "\n";
  std::size_t numbers = 0;
  for (const friction::Curve& curve : result.data.curves) numbers += curve.rows();
  return text + fmt::format("  {} curve{}, {} measured numbers\n", result.data.curves.size(),
                            result.data.curves.size() == 1 ? "" : "s", numbers);
}

std::string best_text(const tasks::LoadingCurveResult& result, const friction::Fit& best) {
  std::string text = fmt::format("\nbest by AIC: {}, {}\n", best.law, best.title) + parameters_table(result, best).text();
  for (const std::string& finding : best.findings) text += "  " + finding + "\n";
  if (!result.of_loops.empty()) text += "\nloops one by one\n" + loops_table(result).text();
  for (const friction::CurveFit* each : tasks::different(result, best)) {
    const std::string of = tasks::different(result, best).size() > 1 ? " of " + each->curve.name : "";
    text += fmt::format("\nequivalent stiffness and damping of {}{}\n", best.law, of) + equivalents_table(*each, 8).text();
  }
  return text;
}

}  // namespace

std::string loading_curve_text(const tasks::LoadingCurveResult& result) {
  std::string text = curves_text(result) + "\n" + laws_table(result).text();
  for (std::size_t i = 0; i < result.slopes.size(); ++i) {
    text += fmt::format("\nu(h) of {} from its slopes, k = {:.6g}\n", result.data.curves[i].name, result.slopes[i].stiffness) +
            slip_forms_table(result.slopes[i]).text();
  }
  if (!result.fits.front().curves.empty()) text += best_text(result, result.fits.front());
  return text;
}

}  // namespace jointid::report
