#include "cli/bound_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/identifiability_json.hpp"

namespace jointid::cli {
namespace {

using Json = nlohmann::ordered_json;

Json value(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

Json changes(const std::vector<ident::BoundChange>& list) {
  Json all = Json::array();
  for (const ident::BoundChange& change : list) {
    Json factors = Json::array();
    for (const double factor : change.factors) factors.push_back(value(factor));
    all.push_back({{"what", change.what}, {"worst", value(change.worst)}, {"mean", value(change.mean)}, {"factors", factors}});
  }
  return all;
}

}  // namespace

Json bound_json(const ident::BoundReport& report) {
  Json unknowns = Json::array();
  for (const ident::UnknownBound& unknown : report.unknowns) {
    unknowns.push_back({{"name", unknown.name},
                        {"unit", unknown.unit},
                        {"value", unknown.value},
                        {"bound", value(unknown.bound)},
                        {"relative", value(unknown.relative)}});
  }
  return {{"variances", report.variances},
          {"unknowns", unknowns},
          {"weakest", weakest_json(report.weakest)},
          {"without_coordinate", changes(report.without_coordinate)},
          {"without_lines", changes(report.without_lines)},
          {"with_more", changes(report.with_more)}};
}

}  // namespace jointid::cli
