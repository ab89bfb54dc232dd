#include "gui/response/response_kind.hpp"

#include <algorithm>

#include "gui/look/said.hpp"
#include "gui/work/control_of.hpp"
#include "report/response/response_page.hpp"
#include "report/response/response_plots.hpp"
#include "report/response/response_tables.hpp"
#include "report/response/response_text.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/run_response.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_rows = 2000, most_of_curve = 500;  // rows of tables

struct Responded {
  tasks::ResponseScene scene;
  tasks::ResponseResult run;
};

std::vector<PlotMenu::Named> plots_of(const tasks::ResponseResult& run) {
  return {{Said::tr("response"), report::level_plots(run)},     {Said::tr("peaks over force"), report::backbone_plots(run)},
          {Said::tr("harmonics"), report::harmonic_plots(run)}, {Said::tr("loop"), report::loop_plots(run)},
          {Said::tr("curve"), report::curve_plots(run)},        {Said::tr("equivalent joints"), report::equivalent_plots(run)},
          {Said::tr("clamping force"), report::clamping_plots(run)},
          {Said::tr("motion"), report::transient_plots(run)}};
}

/// |X|/force over frequency and force level, of three levels or more.
std::vector<PlotMenu::NamedMap> maps_of(const tasks::ResponseResult& run) {
  constexpr std::size_t least_levels = 3;
  std::vector<PlotMenu::NamedMap> out;
  for (const report::Choice& choice : report::level_plots(run).choices) {
    const auto* const magnitude = std::get_if<report::CurvePlot>(&choice.plots.front());
    if (magnitude == nullptr || magnitude->series.size() < least_levels) continue;
    out.emplace_back(Said::tr("map over force levels: %1").arg(q(choice.name)),
                     heat_of(*magnitude, Said::tr("force level").toStdString()));
  }
  return out;
}

std::vector<TableMenu::Named> tables_of(const tasks::ResponseScene& scene, const tasks::ResponseResult& run) {
  std::vector<TableMenu::Named> out;
  std::size_t points = 0;
  for (const tasks::LevelResponse& level : run.levels) points += level.points.size();
  if (!run.levels.empty()) out.emplace_back(Said::tr("peaks"), rows_of(report::peaks_table(run)));
  if (points > 0 && points <= most_rows) out.emplace_back(Said::tr("all points"), rows_of(report::points_table(run)));
  for (const tasks::CurveRun& curve : run.curves) {
    out.emplace_back(q(curve.name + report::curve_remark(curve)), rows_of(report::curve_table(curve, run, most_of_curve)));
  }
  if (!run.equivalents.empty()) out.emplace_back(Said::tr("equivalent joints"), rows_of(report::equivalents_table(run)));
  for (const tasks::ClampingRun& clamping : run.clampings)
    out.emplace_back(Said::tr("clamping force, %1 N").arg(clamping.level), rows_of(report::clamping_table(clamping)));
  if (!run.transients.empty()) out.emplace_back(Said::tr("motions from rest"), rows_of(report::transients_table(run)));
  out.emplace_back(Said::tr("remarks"), remark_rows(report::response_remarks(scene, run)));
  return out;
}

Findings findings_of(const std::shared_ptr<const Responded>& all) {
  Findings out;
  out.is_bad = !tasks::all_converged(all->run);
  out.said =
      out.is_bad ? Said::tr("Some results are missing. Tables and plots leave them out.") : Said::tr("All results were found.");
  out.plots = plots_of(all->run);
  out.maps = maps_of(all->run);
  out.tables = tables_of(all->scene, all->run);
  out.outputs = {{"html", [all] { return report::response_report(all->scene, all->run); }},
                 {"json", [all] { return report::response_json(all->scene, all->run); }},
                 {"csv", [all] { return report::response_csv(all->run); }}};
  return out;
}

/// What it tells one after the other: force levels, their stability, curves, motions from rest.
std::size_t passes_of(const tasks::ResponseScene& scene) {
  const std::size_t levels = scene.levels.size();
  return std::max<std::size_t>(
      1, levels * (scene.stability ? 2 : 1) + scene.curves.size() + (scene.transient ? std::max<std::size_t>(1, levels) : 0));
}

SceneTask read_responses(const std::string& text, const std::filesystem::path& file) {
  const tasks::ResponseScene scene = tasks::parse_response_scene(text, file);
  SceneTask task;
  for (const ident::NamedFile& named : tasks::files_of(scene)) task.inputs.push_back(named.path);
  const auto run = [scene](const Worker::Watch& watch, std::size_t) {
    watch.begin({1, 1, 0.0, 1.0, passes_of(scene)});
    return findings_of(std::make_shared<const Responded>(Responded{scene, tasks::run_response(scene, control_of(watch))}));
  };
  task.run = {run};
  return task;
}

}  // namespace

SceneKind response_kind() {
  SceneKind kind;
  kind.name = "response";
  kind.title = Said::tr("Response");
  kind.jobs = {{{},
                Said::tr("Compute responses"),
                Said::tr("Compute the periodic responses and the other results of the scene, as `jointid response` does"),
                QStringLiteral("jointid response"),
                {}}};
  kind.plots = Said::tr("Responses over frequency and force, loops, motions");
  kind.plot_hint = Said::tr(
      "This page shows the FRFs of a structure with friction joints at all force levels. It also shows peaks over the force "
      "level, harmonics, hysteresis loops and motions. It needs a scene with [structure] or [data] parts, [[joints]], [force] "
      "and [response].");
  kind.tables = Said::tr("Peaks, points, curves and remarks");
  kind.is_of = [](const std::string& text) { return has_table(text, "response"); };
  kind.read = read_responses;
  return kind;
}

}  // namespace jointid::gui
