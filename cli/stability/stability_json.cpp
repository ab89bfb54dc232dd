#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/stability/stability_report.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

report::Json row(const stability::Measured& each) {
  return {{"sweep", each.sweep},
          {"value", each.value},
          {"method", each.method},
          {"solver", each.solver},
          {"lines", each.lines},
          {"unknowns", each.unknowns},
          {"digits_kept", report::value(each.digits_kept)},
          {"digits_true", report::value(each.digits_true)},
          {"digits_stated", report::value(each.digits_stated)},
          {"condition", report::value(each.condition)},
          {"rank", each.rank},
          {"solve_s", each.seconds},
          {"accumulator_bytes", each.bytes},
          {"status", ident::name(each.status)},
          {"warned", each.warned},
          {"verdict", stability::name(each.verdict)}};
}

}  // namespace

std::string stability_json(const StabilityReport& report) {
  report::Json rows = report::Json::array();
  for (const stability::Measured& each : report.rows) rows.push_back(row(each));
  const stability::Count& count = report.count;
  report::Json json = {{"rows", rows},
                       {"random_scenes",
                        {{"seed", report.seed},
                         {"scenes", count.scenes},
                         {"refused", count.refused},
                         {"right", count.right},
                         {"told", count.told},
                         {"silent_wrong", count.silent_wrong},
                         {"silent_wrong_scenes", count.silent},
                         {"false_alarm", count.false_alarm}}}};
  if (report.interrupted) json["interrupted"] = true;
  return report::json_text(json);
}

std::string stability_csv(const StabilityReport& report) {
  std::string csv =
      report::csv_line({"sweep", "value", "method", "solver", "lines", "unknowns", "digits_kept", "digits_true", "digits_stated",
                        "condition", "rank", "solve_s", "accumulator_bytes", "status", "warned", "verdict"});
  for (const stability::Measured& each : report.rows) {
    csv += report::csv_line({each.sweep, report::csv_number(each.value), each.method, each.solver, fmt::format("{}", each.lines),
                             fmt::format("{}", each.unknowns), report::csv_number(each.digits_kept),
                             report::csv_number(each.digits_true), report::csv_number(each.digits_stated),
                             report::csv_number(each.condition), fmt::format("{}", each.rank), report::csv_number(each.seconds),
                             fmt::format("{}", each.bytes), ident::name(each.status), each.warned ? "true" : "false",
                             stability::name(each.verdict)});
  }
  return csv;
}

}  // namespace jointid::cli
