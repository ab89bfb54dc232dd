#include "report/result/bound_json.hpp"

#include <nlohmann/json.hpp>

#include "report/identifiability_json.hpp"
#include "report/json_value.hpp"

namespace jointid::report {
namespace {

Json changes(const std::vector<tasks::BoundChange>& list) {
  Json all = Json::array();
  for (const tasks::BoundChange& change : list) {
    all.push_back({{"what", change.what},
                   {"worst", value(change.worst)},
                   {"mean", value(change.mean)},
                   {"factors", values(change.factors)}});
  }
  return all;
}

}  // namespace

Json bound_json(const tasks::BoundReport& report) {
  Json unknowns = Json::array();
  for (const tasks::UnknownBound& unknown : report.unknowns) {
    unknowns.push_back({{"name", unknown.name},
                        {"unit", unknown.unit},
                        {"value", unknown.value},
                        {"bound", value(unknown.bound)},
                        {"relative", value(unknown.relative)}});
  }
  Json json = {{"variances", report.variances},
               {"unknowns", unknowns},
               {"weakest", weakest_json(report.weakest)},
               {"without_coordinate", changes(report.without_coordinate)},
               {"without_lines", changes(report.without_lines)},
               {"with_more", changes(report.with_more)}};
  if (report.interrupted) json["interrupted"] = true;
  return json;
}

}  // namespace jointid::report
