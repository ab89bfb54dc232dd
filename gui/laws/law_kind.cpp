#include "gui/laws/law_kind.hpp"

#include "gui/look/said.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_plots.hpp"
#include "report/laws/law_text.hpp"

namespace jointid::gui {
namespace {

struct Identified {
  laws::LawScene scene;
  laws::LawIdentification found;
};

std::vector<TableMenu::Named> tables_of(const laws::LawScene& scene, const laws::LawIdentification& found) {
  std::vector<TableMenu::Named> out;
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j) {
    out.emplace_back(q(scene.joints[j].beside.name + ": " + found.laws()[j]), rows_of(report::joint_table(found.fit().joints[j])));
  }
  out.emplace_back(Said::tr("laws compared"), rows_of(report::law_table(found)));
  out.emplace_back(Said::tr("residuals by level"), rows_of(report::level_table(scene, found)));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    out.emplace_back(Said::tr("%1 without a law").arg(q(scene.joints[j].beside.name)), rows_of(report::direct_table(found, j)));
  }
  CellRows notes{{Said::tr("note")}, {}, {}};
  for (const std::string& note : found.notes) notes.cells.push_back({Cell{q(note)}});
  out.emplace_back(Said::tr("notes"), std::move(notes));
  return out;
}

SceneFindings findings_of(const std::shared_ptr<const Identified>& all) {
  SceneFindings out;
  out.is_bad = !laws::is_usable(all->found.status);
  out.said = q(std::string(laws::word(all->found.status))).replace('_', ' ') + ": " + q(laws::laws_text(all->found.laws()));
  if (!all->found.message.empty()) out.said += "\n" + q(all->found.message);
  out.plots = {{Said::tr("joint"), report::law_plots(all->scene, all->found)}};
  out.tables = tables_of(all->scene, all->found);
  out.outputs = {{"html", [all] { return report::law_page(all->scene, all->found); }},
                 {"json", [all] { return report::law_json(all->scene, all->found); }},
                 {"csv", [all] { return report::law_csv(all->scene, all->found); }}};
  return out;
}

bool has_laws(const std::string& text) {
  try {
    return laws::is_law_scene(text, "scene.toml");
  } catch (const InputError&) {
    return false;
  }
}

SceneTask read_laws(const std::string& text, const std::filesystem::path& file) {
  const laws::LawScene scene = laws::parse_law_scene(text, file);
  SceneTask task;
  for (const ident::NamedFile& named : laws::files_of(scene)) task.inputs.push_back(named.path);
  task.run = [scene](const Worker::Watch& watch) {
    watch.progress("fitting friction laws", 0, 0);
    return findings_of(
        std::make_shared<const Identified>(Identified{scene, laws::identify_laws(scene, {.interrupted = watch.interrupted})}));
  };
  return task;
}

}  // namespace

SceneKind law_kind() {
  SceneKind kind;
  kind.name = "laws";
  kind.title = Said::tr("Friction laws");
  kind.run = Said::tr("Identify laws");
  kind.run_hint = Said::tr("Identify the friction laws of the joints from vibration at several force levels, as `jointid solve` does");
  kind.plots = Said::tr("Stiffness and damping of the joints over their motion");
  kind.plot_hint =
      Said::tr("With a scene of friction laws from vibration, [[joint.friction]] and [[data.levels]], the joints' stiffness and damping "
               "over their motion stand here, without a law and by the laws that were found.");
  kind.tables = Said::tr("Joints, laws, residuals");
  kind.command = QStringLiteral("jointid solve");
  kind.is_of = has_laws;
  kind.read = read_laws;
  return kind;
}

}  // namespace jointid::gui
