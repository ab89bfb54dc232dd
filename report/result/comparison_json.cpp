#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/result/comparison_text.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

Json way(const study::Way& chosen) {
  Json equations = Json::array();
  for (const auto equation : chosen.equations) equations.push_back(ident::name(equation));
  const bool weighs = ident::weighs_equations(chosen.method);
  return {{"method", ident::name(chosen.method)},
          {"equations", equations},
          {"weighting", weighs ? Json(weighting::name(chosen.weighting)) : Json(nullptr)},
          {"delta", weighs ? Json(chosen.delta) : Json(nullptr)},
          {"solver", chosen.solver},
          {"regenerate", ident::name(chosen.regenerate)}};
}

Json spread_json(const Spread& s) { return {{"median", value(s.median)}, {"q05", value(s.low)}, {"q95", value(s.high)}}; }

Json combination(const study::Combination& each) {
  Json json = way(each.way);
  json["matrices"] = Json::object();
  for (const study::MatrixFigures& figures : each.matrices) {
    json["matrices"][restrictions::key(figures.kind)] = {{"rjcf", spread_json(figures.rjcf)},
                                                         {"arvf", spread_json(figures.arvf)},
                                                         {"rms_relative_error", spread_json(figures.rms_relative_error)},
                                                         {"bias", value(figures.bias)},
                                                         {"pareto_front", figures.on_front}};
  }
  json["solve_s"] = each.solve_s;
  json["accumulator_bytes"] = each.accumulator_bytes;
  json["statuses"] = Json::object();
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
                                    weighs ? csv_number(each.way.delta) : "",
                                    ident::name(each.way.solver),
                                    restrictions::key(figures.kind)};
  for (const Spread& s : {figures.rjcf, figures.arvf, figures.rms_relative_error}) {
    cells.insert(cells.end(), {csv_number(s.median), csv_number(s.low), csv_number(s.high)});
  }
  cells.insert(cells.end(), {csv_number(figures.bias), figures.on_front ? "true" : "false", csv_number(each.solve_s),
                             fmt::format("{}", each.accumulator_bytes), ident::name(each.way.regenerate)});
  return cells;
}

}  // namespace

std::string comparison_json(const tasks::ComparisonResult& result) {
  Json json = {{"trials", result.trials}, {"seed", result.seed}, {"combinations", Json::array()}, {"left_out", Json::array()}};
  if (result.comparison.interrupted) json["interrupted"] = true;
  for (const auto& each : result.comparison.combinations) json["combinations"].push_back(combination(each));
  for (const auto& each : result.comparison.left_out) {
    Json left_out = way(each.way);
    left_out["reason"] = each.reason;
    json["left_out"].push_back(std::move(left_out));
  }
  return json_text(json);
}

std::string comparison_csv(const tasks::ComparisonResult& result) {
  std::string csv = csv_line({"method",
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
  for (const auto& each : result.comparison.combinations) {
    for (const auto& figures : each.matrices) csv += csv_line(csv_cells(each, figures));
  }
  return csv;
}

}  // namespace jointid::report
