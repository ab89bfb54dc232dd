#include <nlohmann/json.hpp>

#include "report/couple/couple_text.hpp"
#include "report/json_value.hpp"
#include "report/models_json.hpp"

namespace jointid::report {
namespace {

Json file_json(const tasks::CoupledFile& file) {
  return {{"file", file.path.string()}, {"conditions", file.conditions}, {"resonances_hz", file.resonances_hz}};
}

Json dependencies_json(const coupling::Dependencies& dependencies) {
  Json out = {{"reason", dependencies.reason}, {"conditions", Json::array()}};
  for (const coupling::Dependency& condition : dependencies.conditions) {
    out["conditions"].push_back(
        {{"condition", condition.condition},
         {"alpha", {{"median", value(condition.median)}, {"q05", value(condition.lower)}, {"q95", value(condition.upper)}}},
         {"left_out", condition.dependent}});
  }
  return out;
}

}  // namespace

std::string couple_json(const ident::CoupleScene& scene, const tasks::CoupleResult& result) {
  Json out = {{"status", result.status == ident::Status::ok ? "ok" : "not_usable"},
              {"message", result.message},
              {"notes", result.notes},
              {"method", coupling::name(scene.options.method)},
              {"threshold", scene.find_dependent ? "auto" : coupling::name(scene.options.threshold)},
              {"lines", result.lines},
              {"unusable_lines", result.unusable_lines},
              {"result", file_json(result.result)}};
  if (result.with_all) out["with_all"] = file_json(*result.with_all);
  if (result.dependencies) out["dependencies"] = dependencies_json(*result.dependencies);
  if (!result.models.empty()) out["models"] = models_json(result.models, false);
  out["kept"] = Json::array();
  for (const auto& [kept, lines] : kept_counts(result)) out["kept"].push_back({{"conditions", kept}, {"lines", lines}});
  if (const std::size_t worst = worst_line(result); worst != frf::npos) {
    out["condition"] = {{"largest", value(result.records[worst].condition)}, {"frequency_hz", result.frequency_hz[worst]}};
  }
  return json_text(out);
}

}  // namespace jointid::report
