#pragma once

#include <optional>
#include <string_view>

namespace jointid::frf {

/// Reads a cell of a table: a number, or a number and a unit of time behind a blank, as MATLAB writes durations ("0.5 sec"). `comma`: the
/// decimal mark may be a comma. Returns the unit, empty for a number alone; nothing for any other text.
std::optional<std::string_view> read_number_cell(std::string_view cell, bool comma, double& value);

}  // namespace jointid::frf
