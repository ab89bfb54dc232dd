#include "report/laws/law_bound_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/laws/law_text.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using laws::LawBound;
using laws::LevelsBound;

std::string share(const friction::FittedValue& value) {
  if (!value.std_error || !std::isfinite(value.value)) return "–";
  return fmt::format("{:.2g}", 100.0 * *value.std_error / value.value);
}

Json one_value(const friction::FittedValue& of) {
  return {{"name", of.name},
          {"unit", of.unit},
          {"value", value(of.value)},
          {"std_error", value(of.std_error)},
          {"knowledge", friction::name(of.knowledge)}};
}

Json levels_json(const laws::LawScene& scene, const LevelsBound& of) {
  Json out = {{"status", response::word(of.status)}, {"joints", Json::array()}, {"unseen", of.unseen}, {"size", value(of.size)}};
  for (std::size_t j = 0; j < of.joints.size(); ++j) {
    const response::FittedJoint& joint = of.joints[j];
    Json one = {{"name", scene.joints[j].beside.name},
                {"stiffness", one_value(joint.stiffness)},
                {"limit", one_value(joint.limit)},
                {"motion", {value(joint.smallest_motion), value(joint.largest_motion)}},
                {"parameters", Json::array()}};
    for (const friction::FittedValue& each : joint.parameters) one["parameters"].push_back(one_value(each));
    out["joints"].push_back(one);
  }
  return out;
}

}  // namespace

Table worth_table(const laws::LawScene& scene, const LawBound& bound) {
  std::vector<Column> columns = {{bound.measured > 0 ? "with" : "without", Align::left}};
  for (const laws::FrictionJoint& joint : scene.joints) {
    columns.push_back({joint.beside.name + " stiffness ± %"});
    columns.push_back({"limit ± %"});
  }
  columns.push_back({"", Align::left});
  Table table(columns);
  const auto add = [&](const std::string& name, const LevelsBound& of) {
    std::vector<std::string> cells = {name};
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      cells.push_back(j < of.joints.size() ? share(of.joints[j].stiffness) : "–");
      cells.push_back(j < of.joints.size() ? share(of.joints[j].limit) : "–");
    }
    cells.emplace_back(of.status == response::LawFitEnd::converged ? "" : response::word(of.status));
    table.add(cells);
  };
  if (bound.measured > 0) add("the measured levels alone", bound.present);
  for (const laws::LevelWorth& each : bound.worth) add(scene.levels[each.level].name, each.bound);
  if (bound.measured == 0) add("none of them: all levels", bound.all);
  return table;
}

std::string law_bound_text(const laws::LawScene& scene, const LawBound& bound) {
  std::string text =
      (scene.title.empty() ? "" : scene.title + "\n") +
      fmt::format("predicted at the bound: {} lines, {} force levels of which {} measured, harmonics of the model {}–{}\n",
                  bound.lines_hz.size(), scene.levels.size(), bound.measured, bound.harmonics.front(), bound.harmonics.back()) +
      "laws " + (bound.assumed ? "assumed: " : "found from the measured levels: ") + laws::laws_text(bound.laws) + "\n\n";
  text += "all levels together" + (bound.all.joints.empty() ? ": " + std::string(response::word(bound.all.status)) : "") + "\n";
  for (std::size_t j = 0; j < bound.all.joints.size(); ++j) {
    text += scene.joints[j].beside.name + ": " + bound.laws[j] + "\n" + joint_table(bound.all.joints[j]).text() + "\n";
  }
  if (!bound.worth.empty()) {
    text += std::string(bound.measured > 0 ? "which force level to measure next, the best first"
                                           : "what each force level adds, the most important first") +
            "\n" + worth_table(scene, bound).text() + "\n";
  }
  text += notes_text(bound.all.unseen);
  text += notes_text(bound.notes);
  return text;
}

std::string law_bound_json(const laws::LawScene& scene, const LawBound& bound) {
  Json out = {{"laws", bound.laws},
              {"assumed", bound.assumed},
              {"lines_hz", values(bound.lines_hz)},
              {"harmonics", bound.harmonics},
              {"all", levels_json(scene, bound.all)},
              {"measured", bound.measured > 0 ? levels_json(scene, bound.present) : Json()},
              {"levels", Json::array()},
              {"notes", bound.notes}};
  for (const laws::LevelWorth& each : bound.worth)
    out["levels"].push_back(
        {{"name", scene.levels[each.level].name}, {bound.measured > 0 ? "with" : "without", levels_json(scene, each.bound)}});
  return json_text(out);
}

}  // namespace jointid::report
