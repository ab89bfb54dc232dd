#include "gui/oscillate/oscillate_kind.hpp"

#include "gui/look/said.hpp"
#include "gui/work/control_of.hpp"
#include "report/oscillate/oscillate_page.hpp"
#include "report/oscillate/oscillate_plots.hpp"
#include "report/oscillate/oscillate_report.hpp"
#include "tasks/oscillate/run_oscillate.hpp"

namespace jointid::gui {
namespace {

using tasks::OscillateResult;

std::vector<PlotMenu::Named> plots_of(const OscillateResult& run) {
  std::vector<PlotMenu::Named> out{{Said::tr("motion"), report::phase_plots(run)},
                                   {Said::tr("contact"), report::contact_plots(run)}};
  if (run.modes) out.emplace_back(Said::tr("proper orthogonal modes"), report::mode_plots(run));
  if (run.swept) out.emplace_back(Said::tr("bifurcation diagram"), report::sweep_plot(run));
  if (run.reduction) out.emplace_back(Said::tr("reduced models"), report::reduction_plots(*run.reduction));
  return out;
}

/// What the command tells in lines.
CellRows line_rows(const OscillateResult& run) {
  CellRows out{{Said::tr("of"), Said::tr("results")}, {}, {}};
  const auto add = [&](const QString& of, const std::string& line) { out.cells.push_back({Cell{of}, Cell{q(line)}}); };
  add(Said::tr("motion"), report::motion_line(run));
  if (run.orbit) add(Said::tr("periodic orbit"), report::orbit_line(run));
  if (run.swept) add(Said::tr("bifurcation diagram"), report::sweep_line(run));
  for (const std::string& remark : run.remarks) add(Said::tr("remark"), remark);
  return out;
}

std::vector<TableMenu::Named> tables_of(const OscillateResult& run) {
  std::vector<TableMenu::Named> out{{Said::tr("motion and orbit"), line_rows(run)}};
  if (run.modes) {
    out.emplace_back(Said::tr("energy of modes"), rows_of(report::fractions_table(*run.modes)));
    out.emplace_back(Said::tr("mode shapes"), rows_of(report::shapes_table(run)));
  }
  if (run.orbit && run.orbit->converged)
    out.emplace_back(Said::tr("multipliers"), rows_of(report::multipliers_table(*run.orbit)));
  if (run.exponents)
    out.emplace_back(Said::tr("exponents"), rows_of(report::exponents_table(*run.exponents, report::time_unit(run))));
  if (run.reduction) out.emplace_back(Said::tr("reduced models"), rows_of(report::reduction_table(*run.reduction)));
  return out;
}

Findings findings_of(const std::shared_ptr<const OscillateResult>& run) {
  Findings out;
  const std::string failure = tasks::failure_of(*run);
  out.is_bad = !failure.empty();
  out.said = out.is_bad ? q(failure) : Said::tr("All results were found.");
  out.plots = plots_of(*run);
  out.tables = tables_of(*run);
  out.outputs = {{"html", [run] { return report::oscillate_report(*run); }},
                 {"json", [run] { return report::oscillate_json(*run); }},
                 {"csv", [run] { return report::motion_csv(*run); }}};
  return out;
}

SceneTask read_oscillation(const std::string& text, const std::filesystem::path& file) {
  const tasks::OscillateScene scene = tasks::parse_oscillate_scene(text, file);
  SceneTask task;
  for (const ident::NamedFile& named : tasks::files_of(scene)) task.inputs.push_back(named.path);
  const auto run = [scene](const Worker::Watch& watch, std::size_t) {
    return findings_of(std::make_shared<const OscillateResult>(tasks::run_oscillate(scene, control_of(watch))));
  };
  task.run = {run};
  return task;
}

}  // namespace

SceneKind oscillate_kind() {
  SceneKind kind;
  kind.name = "oscillate";
  kind.title = Said::tr("Stick-slip motion");
  kind.jobs = {{{},
                Said::tr("Integrate"),
                Said::tr("Integrate the motion exactly and compute the other results of the scene, as `jointid oscillate` does"),
                QStringLiteral("jointid oscillate"),
                {}}};
  kind.plots = Said::tr("Phase planes, contact, modes, bifurcations");
  kind.plot_hint = Said::tr(
      "This page shows phase planes and Poincaré sections of a system with one friction contact. It also shows the contact, "
      "proper orthogonal modes, the bifurcation diagram and reduced models. It needs a scene with [system], [friction] and "
      "[motion].");
  kind.tables = Said::tr("Orbit, modes, exponents, reduced models");
  kind.is_of = [](const std::string& text) { return has_table(text, "motion"); };
  kind.read = read_oscillation;
  return kind;
}

}  // namespace jointid::gui
