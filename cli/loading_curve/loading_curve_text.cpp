#include <fmt/format.h>

#include <algorithm>

#include "cli/loading_curve/loading_curve_report.hpp"
#include "report/loading_curve/loading_curve_report.hpp"
#include "report/loading_curve/loading_curve_tables.hpp"

namespace jointid::cli {
namespace {

std::string curves_text(const report::LoadingCurveReport& report) {
  std::string text = report.title + "\n";
  for (const std::string& note : report.data.notes) text += "  " + note + "\n";
  std::size_t numbers = 0;
  for (const friction::Curve& curve : report.data.curves) numbers += curve.rows();
  return text + fmt::format("  {} curve{}, {} measured numbers\n", report.data.curves.size(),
                            report.data.curves.size() == 1 ? "" : "s", numbers);
}

std::string best_text(const report::LoadingCurveReport& report, const friction::Fit& best) {
  std::string text = fmt::format("\nbest by AIC: {}, {}\n", best.law, best.title) + parameters_table(report, best).text();
  for (const std::string& finding : best.findings) text += "  " + finding + "\n";
  if (!report.of_loops.empty()) text += "\nloops one by one\n" + loops_table(report).text();
  for (const friction::CurveFit* each : different(report, best)) {
    const std::string of = different(report, best).size() > 1 ? " of " + each->curve.name : "";
    text +=
        fmt::format("\nequivalent stiffness and damping of {}{}\n", best.law, of) + report::equivalents_table(*each, 8).text();
  }
  return text;
}

}  // namespace

std::string loading_curve_text(const report::LoadingCurveReport& report) {
  std::string text = curves_text(report) + "\n" + laws_table(report).text();
  if (!report.fits.front().curves.empty()) text += best_text(report, report.fits.front());
  return text;
}

}  // namespace jointid::cli
