#include "gui/lines/line_kind.hpp"

#include "gui/look/said.hpp"
#include "gui/work/control_of.hpp"
#include "ident/scene/scene_files.hpp"
#include "impedance/identify_lines.hpp"
#include "impedance/scene/read_line_scene.hpp"
#include "report/impedance/line_report.hpp"
#include "scene/kind.hpp"

namespace jointid::gui {
namespace {

constexpr std::size_t most_lines = 500;    // of a table
constexpr std::size_t most_elements = 40;  // in the menu

struct Lines {
  impedance::LineScene scene;
  impedance::IdentifiedLines found;
};

std::vector<PlotMenu::Named> plots_of(const impedance::IdentifiedLines& found) {
  std::vector<PlotMenu::Named> out;
  for (const impedance::WayResult& way : found.ways)
    out.emplace_back(q(impedance::name(way.way)), report::line_element_plots(found, way));
  if (found.freedom > 0.0) out.emplace_back(Said::tr("misfit by line"), report::line_misfit_plot(found));
  return out;
}

std::vector<TableMenu::Named> tables_of(const impedance::IdentifiedLines& found) {
  std::vector<TableMenu::Named> out;
  if (!found.laws.empty()) {
    out.emplace_back(Said::tr("laws compared"), rows_of(report::law_table(found)));
    out.emplace_back(Said::tr("parameters of the best law"), rows_of(report::parameter_table(found.laws.front())));
  }
  for (const impedance::WayResult& way : found.ways) {
    for (std::size_t e = 0; e < std::min(most_elements, way.elements.size()); ++e) {
      out.emplace_back(q(impedance::name(way.way) + ": " + way.elements[e].name),
                       rows_of(report::line_table(found, way, e, most_lines)));
    }
  }
  out.emplace_back(Said::tr("remarks"), remark_rows(found.notes));
  return out;
}

Findings findings_of(const std::shared_ptr<const Lines>& all) {
  Findings out;
  out.is_bad = !is_usable(all->found.status);
  out.said = q(name(all->found.status)).replace('_', ' ');
  if (!all->found.message.empty()) out.said += ": " + q(all->found.message);
  out.plots = plots_of(all->found);
  out.tables = tables_of(all->found);
  out.outputs = {{"html", [all] { return report::line_page(all->scene, all->found); }},
                 {"json", [all] { return report::line_json(all->scene, all->found); }},
                 {"csv", [all] { return report::line_csv(all->found); }}};
  return out;
}

bool has_lines(const std::string& text) {
  try {
    return scene::is_line_scene(text, "scene.toml");
  } catch (const InputError&) {
    return false;
  }
}

SceneTask read_lines(const std::string& text, const std::filesystem::path& file) {
  const impedance::LineScene scene = impedance::parse_line_scene(text, file);
  SceneTask task;
  for (const ident::NamedFile& named : ident::files_of(scene.scene)) task.inputs.push_back(named.path);
  const auto identify = [scene](const Worker::Watch& watch, std::size_t) {
    return findings_of(std::make_shared<const Lines>(Lines{scene, impedance::identify_lines(scene, control_of(watch))}));
  };
  task.run = {identify};
  return task;
}

}  // namespace

SceneKind line_kind() {
  SceneKind kind;
  kind.name = "lines";
  kind.title = Said::tr("Joint line by line");
  kind.jobs = {{Said::tr("Z over frequency"),
                Said::tr("Find Z"),
                Said::tr("Find the dynamic stiffness of the joint at every line, as `jointid solve` does"),
                QStringLiteral("jointid solve"),
                {}}};
  kind.plots = Said::tr("Dynamic stiffness of the joint over frequency");
  kind.plot_hint = Said::tr(
      "This page shows the dynamic stiffness Z of the joint at every line, with 95 % bands, loss factors and laws. It needs a "
      "scene with "
      "[joint] lines.");
  kind.tables = Said::tr("Elements of Z, laws");
  kind.is_of = has_lines;
  kind.read = read_lines;
  return kind;
}

}  // namespace jointid::gui
