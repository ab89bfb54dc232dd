#include "report/series/reversal_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

Json slopes_json(const oscillation::ReversalSlopes& slopes) {
  return {{"parts", slopes.parts}, {"slope", value(slopes.slope)}, {"error", value(slopes.error)}};
}

std::string slopes_text(double slope, double error) {
  return std::isfinite(error) ? fmt::format("{} ± {:.1g}", number(slope, error), error) : number(slope);
}

}  // namespace

std::vector<std::string> reversal_remarks(const tasks::ReversalResult& report) {
  std::vector<std::string> out;
  if (report.missing > 0) out.push_back(fmt::format("{} samples with a missing channel are left out", report.missing));
  if (report.found.skipped > 0)
    out.push_back(fmt::format("{} straight parts have fewer than 3 samples and are left out", report.found.skipped));
  if (!report.found.remark.empty()) out.push_back(report.found.remark);
  return out;
}

Table reversal_table(const tasks::ReversalResult& report) {
  const oscillation::ReversalStiffness& found = report.found;
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"parts forward, backward", fmt::format("{}, {}", found.forward.parts, found.backward.parts)});
  table.add({"slope forward N/m", slopes_text(found.forward.slope, found.forward.error)});
  table.add({"slope backward N/m", slopes_text(found.backward.slope, found.backward.error)});
  table.add({"slope N/m", slopes_text(found.slope, found.slope_error)});
  table.add({"contact stiffness N/m", number(found.stiffness)});
  table.add({"slip force N", number(found.slip_force)});
  table.add({"travel before slip m", number(found.stuck_travel)});
  return table;
}

std::string reversal_text(const tasks::ReversalResult& report) {
  std::string text;
  text += notes_text(reversal_remarks(report));
  return text + reversal_table(report).text();
}

std::string reversal_json(const tasks::ReversalResult& report) {
  const oscillation::ReversalStiffness& found = report.found;
  return json_text({{"status", "ok"},
                    {"forward", slopes_json(found.forward)},
                    {"backward", slopes_json(found.backward)},
                    {"slope", value(found.slope)},
                    {"slope_error", value(found.slope_error)},
                    {"contact_stiffness", value(found.stiffness)},
                    {"slip_force", value(found.slip_force)},
                    {"stuck_travel", value(found.stuck_travel)},
                    {"missing", report.missing},
                    {"remarks", reversal_remarks(report)}});
}

std::string reversal_page(const tasks::ReversalResult& report) {
  ReportPage page(report.file, "jointid series reversal");
  const std::vector<std::string> remarks = reversal_remarks(report);
  page.status(status_banner(remarks.empty() ? "ok" : "doubtful",
                            fmt::format("Contact stiffness {} N/m.", number(report.found.stiffness)), remarks));
  page.section("Slopes after reversals");
  page.add(reversal_table(report));
  page.add(
      Text{"Least squares on straight parts between the limits of slip; the mean of both directions. A delay of the force makes "
           "it too small.",
           true});
  return page.html();
}

}  // namespace jointid::report
