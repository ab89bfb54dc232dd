#include "frf/file/columns.hpp"

#include <algorithm>
#include <cctype>
#include <span>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/file/unit_suffix.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void fail_columns(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, {}, std::move(problem), std::move(remedy)});
}

struct Stem {
  std::string_view name, unit;
};

/// "a/g", "a in m/s²": a quantity over its unit (DIN 1313) or in it; all of it the name where what follows is no unit, or the
/// title is one itself, "m/s".
Stem stem_of(std::string_view title) {
  if (parse_unit(title)) return {title, {}};
  for (const std::string_view sign : {" in ", "/"}) {
    const std::size_t at = title.find(sign);
    if (at == std::string_view::npos || at == 0) continue;
    const std::string_view name = trimmed(title.substr(0, at)), unit = trimmed(title.substr(at + sign.size()));
    if (!unit.empty() && (parse_unit(unit) || !not_a_unit(unit).empty())) return {name, unit};
  }
  return {title, {}};
}

/// "a" of "a/" and "a in", what stands before a unit in brackets.
std::string_view without_sign(std::string_view name) {
  if (name.ends_with('/')) return trimmed(name.substr(0, name.size() - 1));
  return name.ends_with(" in") ? trimmed(name.substr(0, name.size() - 3)) : name;
}

}  // namespace

NumberColumn titled_column(std::string_view header) {
  const bool bracket = header.ends_with(']');
  const std::size_t open = bracket || header.ends_with(')') ? header.rfind(bracket ? '[' : '(') : std::string_view::npos;
  if (open == std::string_view::npos) return {std::string(header), std::string(stem_of(header).unit), {}};
  return {std::string(without_sign(trimmed(header.substr(0, open)))),
          std::string(trimmed(header.substr(open + 1, header.size() - open - 2))),
          {}};
}

std::size_t Columns::place(std::string_view name_or_number) const {
  const auto same = [&](const NumberColumn& column) { return column.name == name_or_number; };
  const std::string wanted = lower_case(name_or_number);
  const auto alike = [&](const NumberColumn& column) { return lower_case(column.name) == wanted; };
  const auto exact = std::ranges::count_if(columns, same), any = exact > 0 ? exact : std::ranges::count_if(columns, alike);
  if (any > 1) {
    fail_columns(file, "the name '" + std::string(name_or_number) + "' is above " + std::to_string(any) + " columns",
                 "give the number of the one that is meant; the columns are " + names());
  }
  const auto found = exact > 0 ? std::ranges::find_if(columns, same) : std::ranges::find_if(columns, alike);
  if (found != columns.end()) return static_cast<std::size_t>(found - columns.begin());
  const auto by_stem = [&](const NumberColumn& column) {
    return lower_case(stem_of(column.name).name) == wanted || lower_case(suffixed_name(column.name).name) == wanted;
  };
  if (!wanted.empty() && std::ranges::count_if(columns, by_stem) == 1)
    return static_cast<std::size_t>(std::ranges::find_if(columns, by_stem) - columns.begin());
  const bool number =
      !wanted.empty() && wanted.size() < 7 && std::ranges::all_of(wanted, [](char c) { return c >= '0' && c <= '9'; });
  const std::size_t index = number ? static_cast<std::size_t>(std::stoul(wanted)) : 0;
  if (index >= 1 && index <= columns.size()) return index - 1;
  fail_columns(file, "there is no column '" + std::string(name_or_number) + "'", "the columns are " + names());
}

std::string Columns::names() const {
  constexpr std::size_t most = 20;
  const std::span<const NumberColumn> shown(columns.data(), std::min(most, columns.size()));
  const std::string list = comma_list(shown, &NumberColumn::name);
  return columns.size() <= most ? list : list + " and " + std::to_string(columns.size() - most) + " more";
}

const NumberColumn* Columns::find(const std::vector<std::string_view>& words,
                                  const std::vector<std::string_view>& without) const {
  for (const NumberColumn& column : columns) {
    std::string text = lower_case(column.name);
    std::ranges::replace_if(
        text, [](unsigned char c) { return std::isalnum(c) == 0; }, ' ');
    const std::vector<std::string_view> parts = split(text, ' ');
    if (std::ranges::find_first_of(parts, words) != parts.end() && std::ranges::find_first_of(parts, without) == parts.end())
      return &column;
  }
  return nullptr;
}

}  // namespace jointid::frf
