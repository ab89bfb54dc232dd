#include "report/check_json.hpp"

#include <nlohmann/json.hpp>

#include "report/json_value.hpp"

namespace jointid::report {

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
  return json;
}

}  // namespace jointid::report
