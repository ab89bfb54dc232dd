#include "report/identifiability_json.hpp"

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"

namespace jointid::report {
namespace {

Json combination(const ident::LinearCombination& of) {
  return {{"unknowns", of.names}, {"factors", of.factors}, {"deviation", value(of.deviation)}};
}

}  // namespace

Json weakest_json(const std::vector<ident::WeakCombination>& weakest) {
  Json all = Json::array();
  for (const ident::WeakCombination& weak : weakest) {
    all.push_back({{"worst", combination(weak.worst)},
                   {"best", weak.best ? combination(*weak.best) : Json(nullptr)},
                   {"correlation", value(weak.correlation)}});
  }
  return all;
}

Json identifiability_json(const ident::Solution& solution) {
  if (!solution.identifiability) return nullptr;
  const ident::Identifiability& found = *solution.identifiability;
  Json json = {{"intervals", ident::name(solution.intervals)},
               {"largest_relative_error", value(found.largest_relative_error)},
               {"joint", {{"effect", value(found.joint.effect)}, {"deformation", value(found.joint.deformation)}}},
               {"weakest", weakest_json(found.weakest)}};
  for (const ident::CalibrationShare& share : found.calibration) {
    Json largest = Json::object();
    for (const auto& [name, part] : share.largest) largest[name] = value(part);
    json["calibration"].push_back({{"unknown", share.unknown}, {"share", value(share.all)}, {"largest", largest}});
  }
  json["findings"] = Json::array();
  for (const ident::Finding& finding : found.findings) {
    json["findings"].push_back({{"kind", ident::name(finding.kind)}, {"text", finding.text}});
  }
  return json;
}

}  // namespace jointid::report
