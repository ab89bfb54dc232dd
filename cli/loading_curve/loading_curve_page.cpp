#include "cli/loading_curve/loading_curve_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/loading_curve/loading_curve_plots.hpp"
#include "report/loading_curve/loading_curve_report.hpp"
#include "report/loading_curve/loading_curve_tables.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::cli {
namespace {

constexpr std::size_t most_curves = 12;

void add_summary(const report::LoadingCurveReport& report, report::ReportPage& page) {
  const friction::Fit& best = report.fits.front();
  page.section("Summary");
  std::size_t numbers = 0;
  for (const friction::Curve& curve : report.data.curves) numbers += curve.rows();
  page.add(report::Facts{{{"curves", fmt::format("{}", report.data.curves.size())},
                          {"measured numbers", fmt::format("{}", numbers)},
                          {"best law by AIC", best.law + ", " + best.title},
                          {"minimiser", best.minimiser}}});
  for (const std::string& note : report.data.notes) page.add(report::Text{note, true});
}

/// The status of the best law, and what the curves cannot tell of it.
report::StatusBanner loading_banner(const report::LoadingCurveReport& report) {
  const friction::Fit& best = report.fits.front();
  if (!some_usable(report)) return report::status_banner(friction::name(best.status), best.message);
  std::vector<std::string> findings;
  for (const std::string& finding : best.findings) findings.push_back(best.law + ": " + finding);
  return report::status_banner("ok", fmt::format("Best law by AIC: {}, {}.", best.law, best.title), std::move(findings));
}

void add_laws(const report::LoadingCurveReport& report, report::ReportPage& page) {
  page.section("Laws compared");
  page.add(laws_table(report));
  page.add(report::Text{
      "AIC weighs the residuals against the number of unknowns, as if residuals were independent: of two laws the lower one "
      "describes these data better. Differences of samples that lie close together are not independent and make it look "
      "surer than it is.",
      true});
  for (const friction::Fit& fit : report.fits) {
    if (!fit.curves.empty()) page.add(parameters_table(report, fit), fit.law);
  }
}

void add_loops(const report::LoadingCurveReport& report, report::ReportPage& page) {
  if (report.of_loops.empty()) return;
  page.section("Loops one by one");
  page.add(loops_table(report));
  page.add(loops_in_turn(report));
}

void add_vibration(const report::LoadingCurveReport& report, report::ReportPage& page) {
  const friction::Fit& best = report.fits.front();
  if (best.curves.empty()) return;
  page.section("What it means for vibration");
  page.add(equivalents_plots(report));
  page.add(report::equivalents_table(*different(report, best).front(), 12), best.law);
  page.add(report::Text{
      "k_e and d_e under x = X cos ωt: the force's first harmonic is (k_e + i·d_e)·X, the energy lost per cycle is π·d_e·X². "
      "Beyond the largest measured displacement they are the law's extrapolation.",
      true});
}

}  // namespace

std::string loading_curve_report(const report::LoadingCurveReport& report) {
  report::ReportPage page(report.title, "jointid loading-curve");
  page.status(loading_banner(report));
  add_summary(report, page);
  add_laws(report, page);
  page.section("Curves and residuals");
  page.add(curves_and_residuals(report, most_curves));
  if (report.data.curves.size() > most_curves) {
    page.add(report::Text{fmt::format("{} of {} curves, evenly chosen; --json and --csv have the figures of all of them.",
                                      most_curves, report.data.curves.size()),
                          true});
  }
  page.section("Slip over the stiffness area");
  page.add(slip_distribution(report));
  page.add(report::Text{"u(h) of (2.53): dT/du = k(1 − h). The level is the largest measured displacement.", true});
  add_loops(report, page);
  add_vibration(report, page);
  return page.html();
}

}  // namespace jointid::cli
