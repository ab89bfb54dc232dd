#include "report/check_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"

namespace jointid::report {

namespace {

Json side_json(const virtualpoint::SideConsistency& side) {
  if (!side.any()) return nullptr;
  Json specific = Json::object();
  for (std::size_t i = 0; i < side.dofs.size(); ++i) specific[side.dofs[i].name()] = value(side.specific[i]);
  return {{"specific", std::move(specific)}, {"overall", side.overall}};
}

Json virtual_point_json(const virtualpoint::Consistency& point) {
  return {{"file", point.file},
          {"virtual_point", point.point},
          {"frequency_hz", point.frequency_hz},
          {"sensors", side_json(point.sensors)},
          {"impacts", side_json(point.impacts)},
          {"rigidity", point.rigidity}};
}

/// To three decimals.
double rounded(double share) { return std::round(1e3 * share) / 1e3; }

}  // namespace

Json check_json(const ident::CheckResult& result) {
  Json json = {{"verdict", ident::name(result.verdict)}, {"suspects", Json::array()}};
  for (const ident::Suspect& suspect : result.suspects) {
    json["suspects"].push_back({{"kind", ident::name(suspect.kind)},
                                {"file", suspect.file},
                                {"dofs", frf::names(suspect.dofs)},
                                {"evidence", suspect.evidence},
                                {"confidence", value(suspect.confidence)},
                                {"remedy", suspect.remedy.empty() ? Json(nullptr) : Json(suspect.remedy)}});
  }
  for (const std::string& note : result.notes) json["notes"].push_back(note);
  for (const ident::ReciprocityMap& map : result.reciprocity) {
    Json entry = {{"file", map.file}, {"rms", value(rounded(map.overall))}};
    if (!map.rms.empty()) entry["dofs"] = frf::names(map.dofs);
    for (const std::vector<double>& row : map.rms) {
      Json numbers = Json::array();
      for (const double each : row) numbers.push_back(value(rounded(each)));
      entry["map"].push_back(std::move(numbers));
    }
    json["reciprocity"].push_back(std::move(entry));
  }
  for (const virtualpoint::Consistency& point : result.virtual_points) json["virtual_points"].push_back(virtual_point_json(point));
  return json;
}

}  // namespace jointid::report
