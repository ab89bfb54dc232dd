#include "report/check_json.hpp"

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
  for (const virtualpoint::Consistency& point : result.virtual_points) json["virtual_points"].push_back(virtual_point_json(point));
  return json;
}

}  // namespace jointid::report
