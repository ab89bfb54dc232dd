#include "cli/solve/bound_json.hpp"

#include <nlohmann/json.hpp>

#include "report/identifiability_json.hpp"
#include "report/json_value.hpp"

namespace jointid::cli {
namespace {

report::Json changes(const std::vector<tasks::BoundChange>& list) {
  report::Json all = report::Json::array();
  for (const tasks::BoundChange& change : list) {
    all.push_back({{"what", change.what},
                   {"worst", report::value(change.worst)},
                   {"mean", report::value(change.mean)},
                   {"factors", report::values(change.factors)}});
  }
  return all;
}

}  // namespace

report::Json bound_json(const tasks::BoundReport& report) {
  report::Json unknowns = report::Json::array();
  for (const tasks::UnknownBound& unknown : report.unknowns) {
    unknowns.push_back({{"name", unknown.name},
                        {"unit", unknown.unit},
                        {"value", unknown.value},
                        {"bound", report::value(unknown.bound)},
                        {"relative", report::value(unknown.relative)}});
  }
  report::Json json = {{"variances", report.variances},
                       {"unknowns", unknowns},
                       {"weakest", report::weakest_json(report.weakest)},
                       {"without_coordinate", changes(report.without_coordinate)},
                       {"without_lines", changes(report.without_lines)},
                       {"with_more", changes(report.with_more)}};
  if (report.interrupted) json["interrupted"] = true;
  return json;
}

}  // namespace jointid::cli
