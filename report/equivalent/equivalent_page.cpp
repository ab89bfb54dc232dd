#include "report/equivalent/equivalent_page.hpp"

#include <algorithm>
#include <functional>

#include "report/equivalent/equivalent_text.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/display_of_tasks.hpp"

namespace jointid::report {
namespace {

CurvePlot plot_of(std::vector<tasks::LevelJoint> levels, const std::string& title, const std::string& label,
                  const std::string& length, const std::function<double(const tasks::EquivalentJoint&)>& value) {
  std::ranges::sort(levels, {}, &tasks::LevelJoint::displacement);
  CurvePlot plot;
  plot.title = title;
  plot.x = {"displacement (" + length + ")", true};
  plot.y = {label, false};
  Series middle{"found", {}, Style::points}, above{"one deviation above", {}, Style::dashed},
      below{"one below", {}, Style::dashed};
  for (const tasks::LevelJoint& level : levels) {
    if (!level.joint.settled) continue;
    plot.x_values.push_back(level.displacement);
    middle.y.push_back(value(level.joint));
    above.y.push_back(value(level.joint) + level.joint.deviation);
    below.y.push_back(value(level.joint) - level.joint.deviation);
  }
  plot.series = {middle, above, below};
  return plot;
}

}  // namespace

std::string equivalent_page(const ident::EquivalentScene& scene, const std::vector<tasks::LevelJoint>& levels,
                            const Display& display) {
  const std::vector<tasks::LevelJoint> shown = in_units_of(display, levels);
  const std::string length = shown_unit(display, "m").unit, stiffness = shown_unit(display, "N/m").unit;
  ReportPage page(scene.title.empty() ? "Equivalent stiffness and damping" : scene.title, "jointid equivalent");
  page.status(tasks::all_settled(levels) ? status_banner(tasks::equivalent_status(levels), tasks::equivalent_doubt(levels))
                                         : status_banner("not_usable", "no stiffness and damping fit the FRFs of some levels"));
  page.section("Over displacement");
  page.add(Text{equivalent_title(scene), true});
  page.add(PlotGroup{"joint",
                     {{"joint",
                       {plot_of(shown, "Equivalent stiffness", "k (" + stiffness + ")", length,
                                [](const auto& joint) { return joint.stiffness; }),
                        plot_of(shown, "Equivalent damping", "d (" + stiffness + ")", length,
                                [](const auto& joint) { return joint.damping; })}}}});
  page.add(Text{
      "Deviations are those that the residuals of a level scatter by; gains of whole FRFs that are off are not in them.", true});
  page.add(equivalent_table(levels, display));
  return page.html();
}

}  // namespace jointid::report
