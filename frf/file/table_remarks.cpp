#include "frf/file/table_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/remarks.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

std::vector<std::string_view> words_of_remark(std::string_view text) {
  constexpr std::string_view signs = " \t,;:=()[]{}\"'#%/|";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(signs); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(signs, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(signs, end);
  }
  return words;
}

/// Words that are units in any sentence; "in" and single letters are not.
bool is_unit_in_sentence(std::string_view word) {
  constexpr auto words = std::to_array<std::string_view>(
      {"mm",         "cm",          "um",   "µm",         "μm",    "nm",     "mil", "mils", "micron", "microns", "inch", "inches",
       "millimeter", "millimeters", "kN",   "mN",         "daN",   "MN",     "lbf", "lb",   "lbs",    "kip",     "kips", "kgf",
       "kilonewton", "ft",          "feet", "millimetre", "tonne", "tonnes", "ms",  "us",   "deg",    "mrad",    "Nmm",  "kNm"});
  return std::ranges::find(words, word) != words.end();
}

bool is_plain_number(std::string_view word) {
  double value = 0.0;
  return !word.empty() && (parse_cell(word, false, value) || parse_cell(word, true, value));
}

/// Of "scale = 0.5" and "# force scale: 0.1", key and value.
std::optional<double> factor_of_remark(std::string_view text) {
  const std::size_t sign = text.find_first_of("=:");
  double value = 1.0;
  if (sign != std::string_view::npos && parse_cell(trimmed(text.substr(sign + 1)), false, value)) {
    std::string key(text.substr(0, sign));
    std::ranges::transform(key, key.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto has = [&](std::string_view part) { return key.find(part) != std::string::npos; };
    const bool named = has("scal") || has("skal") || has("multipl") || has("factor") || has("faktor") || has("facteur");
    if (named && use_of_number(key) == NumberUse::multiplies) return value;
  }
  return stated_factor(text);
}

/// Without the signs of a comment before it.
std::string_view text_of(const TableRemark& remark) {
  return std::string_view(remark.text).substr(std::min(remark.text.find_first_not_of("#% \t"), remark.text.size()));
}

std::size_t longest_of(const Columns& columns) {
  std::size_t longest = 0;
  for (const NumberColumn& column : columns.columns) longest = std::max(longest, column.values.size());
  return longest;
}

[[noreturn]] void refuse_factor(const Columns& columns, std::string place, std::string_view text) {
  throw InputError({ErrorKind::data, columns.file, std::move(place),
                    "states a factor, '" + shown_label(text) + "', which is not applied to the numbers",
                    "multiply them by it and remove it; if that is done already, remove it"});
}

}  // namespace

std::optional<UnreadUnit> unread_unit(const Columns& columns, const std::function<bool(const Unit&)>& is_asked_for) {
  const auto is_unread = [&](std::string_view label) {
    const auto unit = parse_unit(label);
    return unit && unit->si != 1.0 && is_asked_for(*unit);
  };
  for (const TableRemark& remark : columns.remarks) {
    std::vector<std::string_view> labels;
    for (const std::string_view label : labels_in(remark.text)) {
      if (label.size() < remark.text.size()) labels.push_back(label);
    }
    if (const std::size_t in = remark.text.rfind(" in "); in != std::string::npos)  // "mass in g"
      labels.push_back(trimmed(std::string_view(remark.text).substr(in + 4)));
    const auto found = std::ranges::find_if(labels, is_unread);
    if (found != labels.end()) return UnreadUnit{remark.place, std::string(*found)};
    std::string_view before;
    for (const std::string_view word : words_of_remark(remark.text)) {
      const auto unit = is_unit_in_sentence(word) && !is_plain_number(before) ? parse_unit(word) : std::nullopt;
      if (unit && is_asked_for(*unit)) return UnreadUnit{remark.place, std::string(word)};
      before = word;
    }
  }
  return std::nullopt;
}

std::optional<UnreadUnit> unapplied_sensitivity(const Columns& columns) {
  for (const TableRemark& remark : columns.remarks) {
    const std::string plain = lower_case(remark.text);
    const bool applied = plain.find("applied") != std::string::npos && plain.find("not applied") == std::string::npos;
    if ((states_sensitivity(remark.text) || doubts_numbers(remark.text)) && !applied)
      return UnreadUnit{remark.place, std::string(text_of(remark))};
  }
  constexpr std::size_t most_channels = 64;
  const std::size_t longest = longest_of(columns);
  for (const NumberColumn& column : columns.columns) {
    const bool few = !column.values.empty() && column.values.size() <= most_channels && column.values.size() < longest;
    if (few && use_of_number(column.name) == NumberUse::multiplies &&
        std::ranges::any_of(column.values, [](double v) { return v != 1.0; }))
      return UnreadUnit{"column " + column.name, fmt::format("{} = {:g}", column.name, column.values.front())};
  }
  return std::nullopt;
}

void require_no_factor(const Columns& columns) {
  for (const TableRemark& remark : columns.remarks) {
    const std::string_view text = text_of(remark);
    const auto factor = factor_of_remark(text);
    if (factor && *factor != 1.0 && *factor != 0.0) refuse_factor(columns, remark.place, text);
  }
  for (const NumberColumn& number : columns.attributes) {
    const std::string own = number.name.substr(number.name.rfind('@') + 1);
    const double value = number.values.front();
    if (use_of_number(own) == NumberUse::multiplies && value != 1.0 && value != 0.0)
      refuse_factor(columns, number.name, own + " = " + fmt::format("{:g}", value));
  }
  for (const NumberColumn& column : columns.columns) {
    if (factor_in_title(column.name)) refuse_factor(columns, "column " + column.name, column.name);
  }
}

}  // namespace jointid::frf
