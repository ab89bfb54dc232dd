#pragma once

#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "gui/records/record_tool.hpp"

/// What was filled in, as the library wants it. All throw InputError (usage) with the option and what to write.
namespace jointid::gui {

std::string option_text(const ToolValues& values, const char* option);

/// Nothing where the field is empty.
std::optional<double> number_of(const ToolValues& values, const char* option);
std::optional<double> positive_of(const ToolValues& values, const char* option);

/// A whole number of this range.
std::size_t whole_of(const ToolValues& values, const char* option, std::size_t otherwise, std::size_t least, std::size_t most);

/// "0.05,0.1"; empty where there are none.
std::vector<double> numbers_of(const ToolValues& values, const char* option);

}  // namespace jointid::gui
