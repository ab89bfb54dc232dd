#include "report/text/systematic_text.hpp"

#include <fmt/format.h>

#include "base/text.hpp"

namespace jointid::report {
namespace {

std::string with_error(double value, double error) { return fmt::format("{:.6g} ± {:.2g}", value, error); }

}  // namespace

Table systematic_table(const std::vector<ident::SystematicEstimate>& systematic) {
  Table table({{"error of the measurement", Align::left}, {"value"}, {"standard error"}, {"unit", Align::left}, {"prior"}});
  for (const ident::SystematicEstimate& each : systematic) {
    table.add({each.name, fmt::format("{:.6g}", each.value), each.std_error ? fmt::format("{:.2g}", *each.std_error) : "–",
               each.unit, with_error(each.prior, each.prior_deviation)});
  }
  return table;
}

Table calibration_table(const std::vector<ident::CalibrationShare>& shares) {
  Table table({{"unknown", Align::left}, {"calibration"}, {"most of it", Align::left}});
  for (const ident::CalibrationShare& share : shares) {
    const std::string most = comma_list(share.largest, [](const auto& named) { return named.first + " " + percent(named.second); });
    table.add({share.unknown, percent(share.all), most});
  }
  return table;
}

std::string systematic_text(const ident::Solution& solution) {
  if (solution.systematic.empty()) return "";
  std::string text = "\nestimated with the joint\n" + systematic_table(solution.systematic).text();
  if (!solution.identifiability || solution.identifiability->calibration.empty()) return text;
  return text +
         "\nshare of the variance that exact knowledge of these would remove: of all together, of the most important one\n" +
         calibration_table(solution.identifiability->calibration).text();
}

}  // namespace jointid::report
