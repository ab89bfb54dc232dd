#include "report/json_value.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace jointid::report {

Json value(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

Json value(const std::optional<double>& number) { return number ? value(*number) : Json(nullptr); }

Json value(const std::optional<std::array<double, 2>>& interval) { return interval ? values(*interval) : Json(nullptr); }

Json values(std::span<const double> numbers) {
  Json all = Json::array();
  for (const double number : numbers) all.push_back(value(number));
  return all;
}

Json values(const std::vector<std::vector<double>>& matrix) {
  Json all = Json::array();
  for (const auto& row : matrix) all.push_back(values(row));
  return all;
}

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace jointid::report
