#include "report/equivalent/equivalent_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/text/display_of_tasks.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

const char* equation(const ident::EquivalentScene& scene) { return scene.rigid ? "7.18" : "7.11"; }

}  // namespace

std::string equivalent_title(const ident::EquivalentScene& scene) {
  return fmt::format("equivalent stiffness and damping by ({}), FRFs of the parts {}", equation(scene),
                     scene.real ? "made real (7.19)" : "as measured");
}

std::string equivalent_text(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels,
                            const Display& display) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += equivalent_title(scene) + "\n\n";
  if (const std::string doubt = tasks::equivalent_doubt(levels); !doubt.empty()) text += "doubtful: " + doubt + "\n\n";
  text += equivalent_table(levels, display).text() +
          "\n± of either, as the residuals scatter; gains of whole FRFs that are off are not in it\n";
  return text;
}

Table equivalent_table(const std::vector<tasks::LevelJoint>& levels, const Display& display) {
  const std::string length = shown_unit(display, "m").unit, stiffness = shown_unit(display, "N/m").unit;
  Table table(
      {{"displacement " + length}, {"k " + stiffness}, {"d " + stiffness}, {"±"}, {"misfit %"}, {"lines"}, {"", Align::left}});
  for (const tasks::LevelJoint& level : in_units_of(display, levels)) {
    const tasks::EquivalentJoint& joint = level.joint;
    const char* remark = !joint.settled ? "not found"
                         : joint.stiffness < 0.0 || joint.damping < 0.0
                             ? "not physical: the errors of the FRFs outweigh the joint"
                             : "";
    table.add({number(level.displacement), number(joint.stiffness), number(joint.damping), fmt::format("{:.2g}", joint.deviation),
               fmt::format("{:.2f}", 100.0 * joint.misfit), fmt::format("{}", level.lines), remark});
  }
  return table;
}

std::string equivalent_json(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels) {
  Json out = {{"status", tasks::equivalent_status(levels)},
              {"equation", equation(scene)},
              {"real", scene.real},
              {"levels", Json::array()}};
  for (const tasks::LevelJoint& level : levels) {
    out["levels"].push_back({{"file", level.file},
                             {"displacement", level.displacement},
                             {"stiffness", value(level.joint.stiffness)},
                             {"damping", value(level.joint.damping)},
                             {"deviation", value(level.joint.deviation)},
                             {"misfit", value(level.joint.misfit)},
                             {"lines", level.lines},
                             {"settled", level.joint.settled}});
  }
  return json_text(out);
}

std::string equivalent_csv(const std::vector<tasks::LevelJoint>& levels, const Display& display) {
  const std::string length = shown_unit(display, "m").unit, stiffness = shown_unit(display, "N/m").unit;
  std::string text =
      csv_line({"displacement [" + length + "]", "stiffness [" + stiffness + "]", "damping [" + stiffness + "]", "misfit"});
  for (const tasks::LevelJoint& level : in_units_of(display, levels)) {
    if (!level.joint.settled) continue;
    text += csv_line({fmt::format("{}", level.displacement), fmt::format("{}", level.joint.stiffness),
                      fmt::format("{}", level.joint.damping), fmt::format("{}", level.joint.misfit)});
  }
  return text;
}

}  // namespace jointid::report
