#include "frf/mat/mat_column.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "frf/text/unit_names.hpp"

namespace jointid::frf {
namespace {

/// "s.inner." of S.inner.field, empty of a variable.
std::string scope_of(const std::string& name) { return lower_case(name.substr(0, name.rfind('.') + 1)); }

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

std::vector<std::string> ColumnUnits::of(const MatInfo& info) const {
  const std::size_t count = columns_of(info);
  const auto every = [&](const std::string& unit) { return std::vector<std::string>(count, unit); };
  if (!info.unit.empty()) return every(info.unit);
  if (texts_.empty()) return every("");
  const std::string name = lower_case(info.name), scope = scope_of(info.name);
  if (const auto own = texts(name + "_"); own.size() == 1) return every(own.front());
  const auto beside = texts(scope);
  if (beside.size() == 1 && !scope.empty() && is_values(std::string_view(name).substr(scope.size())))
    return every(beside.front());
  if (count > 1 && beside.size() == count && alike_.at({scope, count}) == 1) return beside;
  return every("");
}

}  // namespace jointid::frf
