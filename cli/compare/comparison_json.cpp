#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/compare/comparison_text.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

report::Json way(const study::Way& chosen) {
  report::Json equations = report::Json::array();
  for (const auto equation : chosen.equations) equations.push_back(ident::name(equation));
  const bool weighs = ident::weighs_equations(chosen.method);
  return {{"method", ident::name(chosen.method)},
          {"equations", equations},
          {"weighting", weighs ? report::Json(weighting::name(chosen.weighting)) : report::Json(nullptr)},
          {"delta", weighs ? report::Json(chosen.delta) : report::Json(nullptr)},
          {"solver", chosen.solver},
          {"regenerate", ident::name(chosen.regenerate)}};
}

report::Json spread_json(const Spread& s) {
  return {{"median", report::value(s.median)}, {"q05", report::value(s.low)}, {"q95", report::value(s.high)}};
}

report::Json combination(const study::Combination& each) {
  report::Json json = way(each.way);
  json["matrices"] = report::Json::object();
  for (const study::MatrixFigures& figures : each.matrices) {
    json["matrices"][restrictions::key(figures.kind)] = {{"rjcf", spread_json(figures.rjcf)},
                                                         {"arvf", spread_json(figures.arvf)},
                                                         {"rms_relative_error", spread_json(figures.rms_relative_error)},
                                                         {"bias", report::value(figures.bias)},
                                                         {"pareto_front", figures.on_front}};
  }
  json["solve_s"] = each.solve_s;
  json["accumulator_bytes"] = each.accumulator_bytes;
  json["statuses"] = report::Json::object();
  for (const auto& [status, count] : each.statuses) json["statuses"][ident::name(status)] = count;
  return json;
}

std::vector<std::string> csv_cells(const study::Combination& each, const study::MatrixFigures& figures) {
  std::string equations;
  for (const auto equation : each.way.equations) equations += (equations.empty() ? "" : " ") + ident::name(equation);
  const bool weighs = ident::weighs_equations(each.way.method);
  std::vector<std::string> cells = {ident::name(each.way.method),
                                    equations,
                                    weighs ? weighting::name(each.way.weighting) : "",
                                    weighs ? report::csv_number(each.way.delta) : "",
                                    each.way.solver,
                                    restrictions::key(figures.kind)};
  for (const Spread& s : {figures.rjcf, figures.arvf, figures.rms_relative_error}) {
    cells.insert(cells.end(), {report::csv_number(s.median), report::csv_number(s.low), report::csv_number(s.high)});
  }
  cells.insert(cells.end(),
               {report::csv_number(figures.bias), figures.on_front ? "true" : "false", report::csv_number(each.solve_s),
                fmt::format("{}", each.accumulator_bytes), ident::name(each.way.regenerate)});
  return cells;
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
  report::Json json = {{"trials", report.trials},
                       {"seed", report.seed},
                       {"combinations", report::Json::array()},
                       {"left_out", report::Json::array()}};
  if (report.comparison.interrupted) json["interrupted"] = true;
  for (const auto& each : report.comparison.combinations) json["combinations"].push_back(combination(each));
  for (const auto& each : report.comparison.left_out) {
    report::Json left_out = way(each.way);
    left_out["reason"] = each.reason;
    json["left_out"].push_back(std::move(left_out));
  }
  return report::json_text(json);
}

std::string comparison_csv(const ComparisonReport& report) {
  std::string csv = report::csv_line({"method",
                                      "equations",
                                      "weighting",
                                      "delta",
                                      "solver",
                                      "matrix",
                                      "rjcf",
                                      "rjcf_q05",
                                      "rjcf_q95",
                                      "arvf",
                                      "arvf_q05",
                                      "arvf_q95",
                                      "rms_relative_error",
                                      "rms_relative_error_q05",
                                      "rms_relative_error_q95",
                                      "bias",
                                      "pareto_front",
                                      "solve_s",
                                      "accumulator_bytes",
                                      "regenerate"});
  for (const auto& each : report.comparison.combinations) {
    for (const auto& figures : each.matrices) csv += report::csv_line(csv_cells(each, figures));
  }
  return csv;
}

}  // namespace jointid::cli
