#include "cli/equivalent/equivalent_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

const char* equation(const ident::EquivalentScene& scene) { return scene.rigid ? "7.18" : "7.11"; }

/// No spring or damper beyond the 95 % interval, or a stiffness whose error is larger than itself.
bool is_impossible(const tasks::EquivalentJoint& joint) {
  return joint.stiffness < 0.0 || joint.damping < -normal_95 * joint.deviation || joint.deviation > std::abs(joint.stiffness);
}

}  // namespace

std::string equivalent_status(const std::vector<tasks::LevelJoint>& levels) {
  if (!all_settled(levels)) return "not_usable";
  return equivalent_doubt(levels).empty() ? "ok" : "doubtful";
}

std::string equivalent_doubt(const std::vector<tasks::LevelJoint>& levels) {
  const auto count = [&](const auto& is) {
    return static_cast<std::size_t>(
        std::ranges::count_if(levels, [&](const tasks::LevelJoint& level) { return is(level.joint); }));
  };
  const std::size_t impossible = count(is_impossible);
  if (impossible > 0) {
    return fmt::format(
        "at {} of {} levels no spring and damper: negative beyond the error, or a stiffness whose error is larger than itself; "
        "the errors of the FRFs outweigh the joint",
        impossible, levels.size());
  }
  const std::size_t unknown =
      count([](const tasks::EquivalentJoint& joint) { return joint.deviation > std::abs(joint.damping); });
  return 2 * unknown <= levels.size()
             ? ""
             : fmt::format("the damping is not known: its error is larger than itself at {} of {} levels", unknown,
                           levels.size());
}

bool all_settled(const std::vector<tasks::LevelJoint>& levels) {
  return std::ranges::all_of(levels, [](const tasks::LevelJoint& level) { return level.joint.settled; });
}

std::string equivalent_title(const ident::EquivalentScene& scene) {
  return fmt::format("equivalent stiffness and damping by ({}), FRFs of the parts {}", equation(scene),
                     scene.real ? "made real (7.19)" : "as measured");
}

std::string equivalent_text(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += equivalent_title(scene) + "\n\n";
  if (const std::string doubt = equivalent_doubt(levels); !doubt.empty()) text += "doubtful: " + doubt + "\n\n";
  text += equivalent_table(levels).text() +
          "\n± of either, as the residuals scatter; gains of whole FRFs that are off are not in it\n";
  return text;
}

report::Table equivalent_table(const std::vector<tasks::LevelJoint>& levels) {
  report::Table table({{"displacement m"}, {"k N/m"}, {"d N/m"}, {"±"}, {"misfit %"}, {"lines"}, {"", report::Align::left}});
  for (const tasks::LevelJoint& level : levels) {
    const tasks::EquivalentJoint& joint = level.joint;
    const char* remark = !joint.settled ? "not found"
                         : joint.stiffness < 0.0 || joint.damping < 0.0
                             ? "not physical: the errors of the FRFs outweigh the joint"
                             : "";
    table.add({report::number(level.displacement), report::number(joint.stiffness), report::number(joint.damping),
               fmt::format("{:.2g}", joint.deviation), fmt::format("{:.2f}", 100.0 * joint.misfit),
               fmt::format("{}", level.lines), remark});
  }
  return table;
}

std::string equivalent_json(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels) {
  report::Json out = {{"status", equivalent_status(levels)},
                      {"equation", equation(scene)},
                      {"real", scene.real},
                      {"levels", report::Json::array()}};
  for (const tasks::LevelJoint& level : levels) {
    out["levels"].push_back({{"file", level.file},
                             {"displacement", level.displacement},
                             {"stiffness", report::value(level.joint.stiffness)},
                             {"damping", report::value(level.joint.damping)},
                             {"deviation", report::value(level.joint.deviation)},
                             {"misfit", report::value(level.joint.misfit)},
                             {"lines", level.lines},
                             {"settled", level.joint.settled}});
  }
  return report::json_text(out);
}

std::string equivalent_csv(const std::vector<tasks::LevelJoint>& levels) {
  std::string text = report::csv_line({"displacement [m]", "stiffness [N/m]", "damping [N/m]", "misfit"});
  for (const tasks::LevelJoint& level : levels) {
    if (!level.joint.settled) continue;
    text += report::csv_line({fmt::format("{}", level.displacement), fmt::format("{}", level.joint.stiffness),
                              fmt::format("{}", level.joint.damping), fmt::format("{}", level.joint.misfit)});
  }
  return text;
}

}  // namespace jointid::cli
