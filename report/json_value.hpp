#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace jointid::report {

using Json = nlohmann::ordered_json;

/// JSON has neither NaN nor infinity: null stands for them, as for what there is not.
Json value(double number);
Json value(const std::optional<double>& number);

/// An interval [low, high].
Json value(const std::optional<std::array<double, 2>>& interval);

/// A list, or a matrix row by row.
Json values(std::span<const double> numbers);
Json values(const std::vector<std::vector<double>>& matrix);

/// What a file holds: two blanks a level, bytes that are no UTF-8 replaced.
std::string json_text(const Json& json);

}  // namespace jointid::report
