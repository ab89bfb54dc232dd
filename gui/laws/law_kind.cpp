#include "gui/laws/law_kind.hpp"

#include "base/parallel.hpp"
#include "gui/look/said.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/identify_laws.hpp"
#include "laws/task/law_bound.hpp"
#include "laws/task/law_study.hpp"
#include "report/laws/law_bound_text.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_plots.hpp"
#include "report/laws/law_study_page.hpp"
#include "report/laws/law_study_text.hpp"
#include "report/laws/law_text.hpp"
#include "scene/kind.hpp"

namespace jointid::gui {
namespace {

struct Identified {
  laws::LawScene scene;
  laws::LawIdentification found;
};

std::vector<TableMenu::Named> tables_of(const laws::LawScene& scene, const laws::LawIdentification& found) {
  std::vector<TableMenu::Named> out;
  for (std::size_t j = 0; j < found.fit().joints.size(); ++j) {
    out.emplace_back(q(scene.joints[j].beside.name + ": " + found.laws()[j]),
                     rows_of(report::joint_table(found.fit().joints[j])));
  }
  out.emplace_back(Said::tr("laws compared"), rows_of(report::law_table(found)));
  out.emplace_back(Said::tr("residuals by force level"), rows_of(report::level_table(scene, found)));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    out.emplace_back(Said::tr("%1 without a law").arg(q(scene.joints[j].beside.name)), rows_of(report::direct_table(found, j)));
  }
  out.emplace_back(Said::tr("remarks"), remark_rows(found.notes));
  return out;
}

Findings findings_of(const std::shared_ptr<const Identified>& all) {
  Findings out;
  out.is_bad = !is_usable(all->found.status);
  out.said = q(name(all->found.status)).replace('_', ' ') + ": " + q(laws::laws_text(all->found.laws()));
  if (!all->found.message.empty()) out.said += "\n" + q(all->found.message);
  out.plots = {{Said::tr("joint"), report::law_plots(all->scene, all->found)}};
  out.tables = tables_of(all->scene, all->found);
  out.outputs = {{"html", [all] { return report::law_page(all->scene, all->found); }},
                 {"json", [all] { return report::law_json(all->scene, all->found); }},
                 {"csv", [all] { return report::law_csv(all->scene, all->found); }}};
  return out;
}

/// What the levels will tell, before all of them are measured.
Findings bounds_of(const laws::LawScene& scene, const laws::LawBound& bound) {
  Findings out;
  out.is_bad = bound.all.joints.empty();
  out.said = q(out.is_bad ? std::string(response::word(bound.all.status)) : laws::laws_text(bound.laws)) + "\n" +
             (bound.assumed ? Said::tr("The laws are those of the scene (assumed).")
                            : Said::tr("The laws are those of the measured force levels."));
  for (std::size_t j = 0; j < bound.all.joints.size(); ++j) {
    out.tables.emplace_back(q(scene.joints[j].beside.name + ": " + bound.laws[j]),
                            rows_of(report::joint_table(bound.all.joints[j])));
  }
  if (!bound.worth.empty()) {
    out.tables.emplace_back(
        bound.measured > 0 ? Said::tr("force level to measure next") : Said::tr("benefit of each force level"),
        rows_of(report::worth_table(scene, bound)));
  }
  std::vector<std::string> remarks = bound.all.unseen;
  remarks.insert(remarks.end(), bound.notes.begin(), bound.notes.end());
  out.tables.emplace_back(Said::tr("remarks"), remark_rows(remarks));
  out.outputs = {{"json", [json = report::law_bound_json(scene, bound)] { return json; }}};
  return out;
}

Findings study_of(const laws::LawScene& scene, const std::shared_ptr<const laws::LawStudy>& study) {
  Findings out;
  out.is_bad = study->usable == 0;
  out.said = q(report::law_study_summary(*study)).trimmed();
  out.tables = {{Said::tr("errors and intervals"), rows_of(report::law_values_table(*study))},
                {Said::tr("remarks"), remark_rows(study->notes)}};
  out.plots = {{Said::tr("results"), report::law_study_plots(*study)}};
  out.outputs = {{"html", [scene, study] { return report::law_study_page(scene, *study); }},
                 {"json", [study] { return report::law_study_json(*study); }},
                 {"csv", [study] { return report::law_study_csv(*study); }}};
  return out;
}

bool has_laws(const std::string& text) {
  try {
    return scene::is_law_scene(text, "scene.toml");
  } catch (const InputError&) {
    return false;
  }
}

SceneTask read_laws(const std::string& text, const std::filesystem::path& file) {
  const laws::LawScene scene = laws::parse_law_scene(text, file);
  SceneTask task;
  for (const ident::NamedFile& named : laws::files_of(scene)) task.inputs.push_back(named.path);
  const auto identify = [scene](const Worker::Watch& watch, std::size_t) {
    watch.progress("fitting friction laws", 0, 0);
    return findings_of(
        std::make_shared<const Identified>(Identified{scene, laws::identify_laws(scene, {.interrupted = watch.interrupted})}));
  };
  const auto predict = [scene](const Worker::Watch& watch, std::size_t) {
    watch.progress("predicting", 0, 0);
    return bounds_of(scene, laws::predict_law_bound(scene));
  };
  const auto study = [scene](const Worker::Watch& watch, std::size_t trials) {
    laws::LawStudyOptions options{.trials = trials, .threads = threads_or_cores(0), .interrupted = watch.interrupted};
    options.progress = [&](std::size_t done, std::size_t total) { watch.progress("trials", done, total); };
    return study_of(scene, std::make_shared<const laws::LawStudy>(laws::study_laws(scene, options)));
  };
  task.run = {identify, predict, study};
  return task;
}

}  // namespace

SceneKind law_kind() {
  SceneKind kind;
  kind.name = "laws";
  kind.title = Said::tr("Friction laws");
  kind.jobs = {
      {Said::tr("Laws"),
       Said::tr("Identify laws"),
       Said::tr("Identify the friction laws of the joints from vibration at several force levels, as `jointid solve` does"),
       QStringLiteral("jointid solve"),
       {}},
      {Said::tr("Bounds"), Said::tr("Predict bounds"),
       Said::tr("Predict the standard errors and the force level to measure next, as `jointid plan --bound` does"),
       QStringLiteral("jointid plan"), QStringLiteral(" --bound")},
      {Said::tr("Study"),
       Said::tr("Simulate tests"),
       Said::tr("Errors and coverage of the intervals over simulated tests, as `jointid study` does"),
       QStringLiteral("jointid study"),
       {},
       true}};
  kind.plots = Said::tr("Stiffness and damping of the joints over their motion");
  kind.plot_hint = Said::tr(
      "This page shows stiffness and damping of the joints over their motion, without a law and by the identified laws. It needs "
      "a scene with [[joint.friction]] and [[data.levels]].");
  kind.tables = Said::tr("Joints, laws, residuals");
  kind.is_of = has_laws;
  kind.read = read_laws;
  return kind;
}

}  // namespace jointid::gui
