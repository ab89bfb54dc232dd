#include "report/models_json.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace jointid::report {
namespace {

constexpr std::array ways = {"modes", "full", "factorised", "reduced"};

Json planned_json(const models::ModelUse& use) {
  return {{"vectors", use.expected_vectors}, {"memory_bytes", use.expected_bytes}, {"processor_s", use.expected_seconds}};
}

}  // namespace

Json models_json(const std::vector<ident::UsedModel>& models, bool planned) {
  Json all = Json::array();
  for (const auto& [file, use] : models) {
    Json out = {{"file", file}, {"coordinates", use.coordinates}, {"way", ways[static_cast<std::size_t>(use.way)]}};
    if (!use.reason.empty()) out["reason"] = use.reason;
    if (use.way == models::ModelWay::reduced) out["bound"] = use.bound;
    if (planned) {
      if (use.expected_bytes > 0.0) out["expected"] = planned_json(use);
    } else {
      if (use.vectors > 0)
        out["basis"] = {
            {"vectors", use.vectors}, {"shifts", use.shifts}, {"error", value(use.error)}, {"worst_hz", value(use.worst_hz)}};
      out["reduced_lines"] = use.reduced_lines;
      out["factorizations"] = use.factorizations;
    }
    all.push_back(std::move(out));
  }
  return all;
}

std::vector<ident::UsedModel> models_of_json(const Json& json) {
  std::vector<ident::UsedModel> out;
  for (const Json& each : json) {
    models::ModelUse use;
    const auto way = std::ranges::find(ways, each.at("way").get<std::string>());
    use.way = static_cast<models::ModelWay>(std::min<std::ptrdiff_t>(way - ways.begin(), 3));
    use.reason = each.value("reason", "");
    use.coordinates = each.at("coordinates").get<std::size_t>();
    use.bound = each.value("bound", 0.0);
    use.reduced_lines = each.at("reduced_lines").get<std::size_t>();
    use.factorizations = each.at("factorizations").get<std::size_t>();
    if (const auto basis = each.find("basis"); basis != each.end()) {
      use.vectors = basis->at("vectors").get<std::size_t>();
      use.shifts = basis->at("shifts").get<std::size_t>();
      use.error = basis->at("error").get<double>();
      use.worst_hz = basis->at("worst_hz").get<double>();
    }
    out.push_back({each.at("file").get<std::string>(), use});
  }
  return out;
}

}  // namespace jointid::report
