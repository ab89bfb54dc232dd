#include "report/loading_curve/loading_curve_page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/loading_curve/loading_curve_plots.hpp"
#include "report/loading_curve/loading_curve_tables.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "tasks/loading_curve/loading_curve_result.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_curves = 12;

void add_summary(const tasks::LoadingCurveResult& result, ReportPage& page) {
  const friction::Fit& best = result.fits.front();
  page.section("Summary");
  std::size_t numbers = 0;
  for (const friction::Curve& curve : result.data.curves) numbers += curve.rows();
  page.add(Facts{{{"curves", fmt::format("{}", result.data.curves.size())},
                  {"measured numbers", fmt::format("{}", numbers)},
                  {"best law by AIC", best.law + ", " + best.title},
                  {"minimiser", best.minimiser}}});
  for (const std::string& note : result.data.notes) page.add(Text{note, true});
}

/// The status of the best law, and what the curves cannot tell of it.
StatusBanner loading_banner(const tasks::LoadingCurveResult& result) {
  const friction::Fit& best = result.fits.front();
  if (!tasks::some_usable(result)) return status_banner(name(best.status), best.message);
  std::vector<std::string> findings;
  for (const std::string& finding : best.findings) findings.push_back(best.law + ": " + finding);
  return status_banner("ok", fmt::format("Best law by AIC: {}, {}.", best.law, best.title), std::move(findings));
}

void add_laws(const tasks::LoadingCurveResult& result, ReportPage& page) {
  page.section("Laws compared");
  page.add(laws_table(result));
  page.add(
      Text{"AIC weighs the residuals against the number of unknowns, as if residuals were independent: of two laws the lower one "
           "describes these data better. Differences of samples that lie close together are not independent and make it look "
           "surer than it is.",
           true});
  for (const friction::Fit& fit : result.fits) {
    if (!fit.curves.empty()) page.add(parameters_table(result, fit), fit.law);
  }
}

void add_loops(const tasks::LoadingCurveResult& result, ReportPage& page) {
  if (result.of_loops.empty()) return;
  page.section("Loops one by one");
  page.add(loops_table(result));
  page.add(loops_in_turn(result));
}

void add_vibration(const tasks::LoadingCurveResult& result, ReportPage& page) {
  const friction::Fit& best = result.fits.front();
  if (best.curves.empty()) return;
  page.section("What it means for vibration");
  page.add(equivalents_plots(result));
  page.add(equivalents_table(*tasks::different(result, best).front(), 12), best.law);
  page.add(Text{
      "k_e and d_e under x = X cos ωt: the force's first harmonic is (k_e + i·d_e)·X, the energy lost per cycle is π·d_e·X². "
      "Beyond the largest measured displacement they are the law's extrapolation.",
      true});
}

}  // namespace

std::string loading_curve_page(const tasks::LoadingCurveResult& result) {
  ReportPage page(result.title, "jointid loading-curve");
  page.status(loading_banner(result));
  add_summary(result, page);
  add_laws(result, page);
  page.section("Curves and residuals");
  page.add(curves_and_residuals(result, most_curves));
  if (result.data.curves.size() > most_curves) {
    page.add(Text{fmt::format("{} of {} curves, evenly chosen; --json and --csv have the figures of all of them.", most_curves,
                              result.data.curves.size()),
                  true});
  }
  page.section("Slip over the stiffness area");
  page.add(slip_distribution(result));
  page.add(Text{"u(h) of (2.53): dT/du = k(1 − h). The level is the largest measured displacement.", true});
  add_loops(result, page);
  add_vibration(result, page);
  return page.html();
}

}  // namespace jointid::report
