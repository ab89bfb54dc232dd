#include "gui/records/tool_values.hpp"

#include <QLocale>
#include <cmath>

#include "base/error.hpp"

namespace jointid::gui {

std::string option_text(const ToolValues& values, const char* option) {
  const auto place = values.find(option);
  return place == values.end() ? std::string() : place->second.toStdString();
}

std::optional<double> number_of(const ToolValues& values, const char* option) {
  const auto place = values.find(option);
  if (place == values.end()) return std::nullopt;
  bool is_number = false;
  const double value = QLocale::c().toDouble(place->second, &is_number);
  if (!is_number)
    throw InputError({ErrorKind::usage, "", option, "'" + place->second.toStdString() + "' is no number", "write 0.002 or 2e-3"});
  return value;
}

std::optional<double> positive_of(const ToolValues& values, const char* option) {
  const std::optional<double> value = number_of(values, option);
  if (value && !(*value > 0.0))
    throw InputError(
        {ErrorKind::usage, "", option, values.at(option).toStdString() + " is not above 0", "give a number above 0"});
  return value;
}

std::size_t whole_of(const ToolValues& values, const char* option, std::size_t otherwise, std::size_t least, std::size_t most) {
  const std::optional<double> value = number_of(values, option);
  if (!value) return otherwise;
  if (*value != std::floor(*value) || *value < static_cast<double>(least) || *value > static_cast<double>(most)) {
    throw InputError({ErrorKind::usage, "", option, values.at(option).toStdString() + " is not allowed",
                      "give a whole number from " + std::to_string(least) + " to " + std::to_string(most)});
  }
  return static_cast<std::size_t>(*value);
}

std::vector<double> numbers_of(const ToolValues& values, const char* option) {
  std::vector<double> out;
  const auto place = values.find(option);
  if (place == values.end()) return out;
  for (const QString& word : place->second.split(',')) out.push_back(*number_of({{option, word.trimmed()}}, option));
  return out;
}

}  // namespace jointid::gui
