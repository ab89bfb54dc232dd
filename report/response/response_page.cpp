#include "report/response/response_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/response/response_plots.hpp"
#include "report/response/response_tables.hpp"
#include "report/response/response_text.hpp"

namespace jointid::report {
namespace {

void add_summary(const tasks::ResponseScene& scene, const tasks::ResponseResult& run, ReportPage& page) {
  const bool all = all_converged(run);
  page.status(status_banner(all ? "ok" : "not_converged",
                            all ? "Everything that was asked for was found."
                                : "Not everything was found; what is missing is left out of tables and plots.",
                            response_remarks(scene, run)));
  page.section("Summary");
  std::size_t points = 0;
  for (const tasks::LevelResponse& level : run.levels) points += level.points.size();
  Facts facts{
      {{"joints", fmt::format("{}", fmt::join(run.joints, ", "))}, {"responses", fmt::format("{}", fmt::join(run.dofs, ", "))}}};
  if (!run.levels.empty()) {
    facts.rows.emplace_back("force at", scene.force_dof.name);
    facts.rows.emplace_back("points", fmt::format("{}", points));
  }
  page.add(facts);
}

void add_levels(const tasks::ResponseResult& run, ReportPage& page) {
  if (run.levels.empty()) return;
  page.section("Response over frequency");
  page.add(level_plots(run));
  page.add(peaks_table(run), "Peaks");
  page.add(Text{"Damping is that of a linear structure whose joints keep their force over motion at the peak.", true});
  page.add(backbone_plots(run));
  const PlotGroup harmonics = harmonic_plots(run);
  if (!harmonics.choices.empty()) {
    page.section("Harmonics");
    page.add(harmonics);
  }
  page.section("Loops of the joints");
  page.add(loop_plots(run));
}

void add_further(const tasks::ResponseResult& run, ReportPage& page) {
  if (!run.curves.empty()) {
    page.section("Curves");
    page.add(curve_plots(run));
    for (const tasks::CurveRun& curve : run.curves) page.add(curve_table(curve, run, 20), curve.name + curve_remark(curve));
  }
  if (!run.equivalents.empty()) {
    page.section("Equivalent joints");
    page.add(equivalent_plots(run));
    page.add(equivalents_table(run));
  }
  if (!run.clampings.empty()) {
    page.section("Clamping force");
    page.add(clamping_plots(run));
    for (const tasks::ClampingRun& clamping : run.clampings) page.add(clamping_table(clamping), clamping_verdict(clamping));
  }
  if (!run.transients.empty()) {
    page.section("Motions from rest");
    page.add(transient_plots(run));
    page.add(transients_table(run));
  }
}

}  // namespace

std::string response_report(const tasks::ResponseScene& scene, const tasks::ResponseResult& run) {
  ReportPage page(scene.title.empty() ? scene.file.filename().string() : scene.title, "jointid response");
  add_summary(scene, run, page);
  add_levels(run, page);
  add_further(run, page);
  return page.html();
}

}  // namespace jointid::report
