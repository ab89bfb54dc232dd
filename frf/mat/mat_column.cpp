#include "frf/mat/mat_column.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "frf/set/unit_label.hpp"
#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"
#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// "s.inner." of S.inner.field, empty of a variable.
std::string scope_of(const std::string& name) { return lower_case(name.substr(0, name.rfind('.') + 1)); }

/// "N, g", "N; g", "N g" and ["N", "g"] as so many units; nothing where they are not.
std::vector<std::string> listed_units(std::string text, std::size_t count) {
  constexpr std::string_view frames = "[]()'\"";
  if (text.starts_with('[') || text.starts_with('('))
    std::erase_if(text, [&](char c) { return frames.find(c) != std::string_view::npos; });
  for (const char sign : {';', ',', '|', '\n', ' '}) {
    const std::vector<std::string_view> parts = split(text, sign);
    if (parts.size() == count) return {parts.begin(), parts.end()};
  }
  return {};
}

bool is_values(std::string_view field) {
  constexpr std::array<std::string_view, 4> names = {"values", "value", "data", "y"};
  return std::ranges::find(names, field) != names.end();
}

}  // namespace

bool is_column(const MatInfo& info) {
  return info.kind == MatKind::real && !info.dims.empty() && info.dims.size() <= 2 && info.name.find('(') == std::string::npos;
}

std::size_t columns_of(const MatInfo& info) { return info.dims.size() == 2 ? std::min(info.dims[0], info.dims[1]) : 1; }

std::string column_name(const MatInfo& info, std::size_t k) {
  return columns_of(info) == 1 ? info.name : info.name + "(" + std::to_string(k + 1) + ")";
}

ColumnUnits::ColumnUnits(MatFile& file) : file_(file) {
  for (const MatInfo& info : file.variables()) {
    if (info.kind == MatKind::text) texts_.emplace(lower_case(info.name), &info);
    if (info.kind == MatKind::real) ++alike_[{scope_of(info.name), columns_of(info)}];
  }
}

std::vector<std::string> ColumnUnits::texts(const std::string& name) const {
  for (const char* ending : {"unit", "units"}) {
    const auto found = texts_.find(name + ending);
    if (found != texts_.end()) return file_.read(*found->second).texts;
  }
  return {};
}

std::vector<std::string> ColumnUnits::used(const std::string& name, std::vector<std::string> texts) const {
  for (const char* ending : {"unit", "units"}) used_.insert(name + ending);
  return texts;
}

/// Of "xunit", "x_unit" and "xlabel"; empty where none is there.
std::string ColumnUnits::of_axis(const std::string& scope, char axis) const {
  const std::string name = scope + axis;
  for (const std::string& prefix : {name, name + "_"}) {
    if (const auto own = texts(prefix); own.size() == 1) return used(prefix, own).front();
  }
  for (const char* ending : {"label", "_label"}) {
    const auto found = texts_.find(name + ending);
    if (found == texts_.end()) continue;
    const std::vector<std::string> label = file_.read(*found->second).texts;
    const std::vector<std::string_view> labels = label.size() == 1 ? labels_in(label.front()) : std::vector<std::string_view>();
    const auto unit = std::ranges::find_if(labels, [](std::string_view each) { return parse_unit(each).has_value(); });
    if (unit == labels.end()) continue;
    used_.insert(found->first);
    return std::string(*unit);
  }
  return {};
}

std::vector<std::pair<std::string, std::string>> ColumnUnits::unread() const {
  constexpr std::size_t most = 100, longest = 64;
  const auto is_of_units = [](const std::string& name) {
    return name.find("unit") != std::string::npos || name.find("label") != std::string::npos ||
           name.find("title") != std::string::npos || name.find("sensitiv") != std::string::npos ||
           name.find("calib") != std::string::npos;
  };
  std::vector<std::pair<std::string, std::string>> out;
  const auto add = [&](const std::string& name, const std::string& text) {
    if (out.size() < most && text.size() <= longest) out.emplace_back(name, text);
  };
  for (const auto& [name, info] : texts_) {
    std::size_t size = 1;
    for (const std::size_t extent : info->dims) size *= extent;
    if (used_.contains(name) || !is_of_units(name) || size > longest * longest) continue;
    for (const std::string& text : file_.read(*info).texts) add(info->name, text);
  }
  std::set<std::string> known;
  for (const MatInfo& info : file_.variables()) {
    if (!is_column(info) || known.size() > most) continue;
    for (const auto& [name, text] : file_.notes(info)) {
      const std::string own = lower_case(name.substr(name.rfind('@') + 1));
      const bool read = !info.unit.empty() && (own == "unit" || own == "units") && name.starts_with(info.name + "@");
      if (!read && is_of_units(own) && known.insert(name).second) add(name, text);
    }
  }
  return out;
}

std::vector<std::string> ColumnUnits::of(const MatInfo& info) const {
  const std::size_t count = columns_of(info);
  const auto every = [&](const std::string& unit) { return std::vector<std::string>(count, unit); };
  if (!info.unit.empty()) {
    const auto listed = count > 1 ? listed_units(info.unit, count) : std::vector<std::string>();
    return listed.empty() ? every(info.unit) : listed;
  }
  if (texts_.empty()) return every("");
  const std::string name = lower_case(info.name), scope = scope_of(info.name), field = name.substr(scope.size());
  if (const auto own = texts(name + "_"); own.size() == 1) return every(used(name + "_", own).front());
  for (const char* group : {"unit.", "units."}) {
    const auto found = texts_.find(scope + group + field);
    if (found == texts_.end()) continue;
    used_.insert(found->first);
    if (const auto own = file_.read(*found->second).texts; own.size() == 1) return every(own.front());
  }
  if (field == "x" || field == "y" || is_values(field)) {
    if (const std::string own = of_axis(scope, field == "x" ? 'x' : 'y'); !own.empty()) return every(own);
  }
  const auto beside = texts(scope);
  if (beside.size() == 1 && !scope.empty() && is_values(field)) return every(used(scope, beside).front());
  if (count > 1 && beside.size() == count && alike_.at({scope, count}) == 1) return used(scope, beside);
  return every("");
}

}  // namespace jointid::frf
