#include "frf/file/node_table.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "frf/file/columns.hpp"
#include "frf/file/file_head.hpp"
#include "frf/file/table_remarks.hpp"
#include "frf/set/unit_label.hpp"
#include "frf/uff/uff_file.hpp"
#include "frf/uff/uff_lines.hpp"

namespace jointid::frf {
namespace {

[[noreturn]] void refuse_table(const Columns& table, std::string place, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, table.file, std::move(place), std::move(problem), std::move(remedy)});
}

/// A column by one of its names, whatever their case.
const NumberColumn& column_of(const Columns& table, const std::vector<std::string_view>& names) {
  const NumberColumn* found = table.find(names);
  if (found == nullptr)
    refuse_table(table, {}, "has no column " + std::string(names.front()) + "; the columns are " + table.names(),
                 "give titles node, x [mm], y [mm], z [mm], and a row for each node");
  return *found;
}

const NumberColumn& ids_of(const Columns& table) {
  return column_of(table, {"node", "id", "point", "nr", "knoten", "punkt", "grid", "label", "no"});
}

std::string row_of(std::size_t i) { return "row " + std::to_string(i + 1) + " of numbers"; }

std::int64_t node_of(const Columns& table, const NumberColumn& nodes, std::size_t i) {
  constexpr double most = 9e15;
  const double value = nodes.values[i];
  if (value != std::floor(value) || std::abs(value) > most)
    refuse_table(table, row_of(i), "the node is no whole number", "number the nodes as the DOFs do");
  return static_cast<std::int64_t>(value);
}

double meters_per(const Columns& table, const NumberColumn& column) {
  if (states_no_unit(column.unit)) return 1.0;
  const auto unit = parse_unit(column.unit), meter = parse_unit("m");
  if (!unit || !unit->same_dimension(*meter))
    refuse_table(table, "column " + column.name, "'" + shown_label(column.unit) + "' is no length", "write m, mm or in");
  return unit->si;
}

/// 100 m are no structure that is tested by FRFs at nodes: these are millimetres.
void require_size(const Columns& table, const std::vector<Node>& nodes) {
  constexpr double largest = 100.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::ranges::minmax(nodes, {}, [&](const Node& node) { return node.position[axis]; });
    if (high.position[axis] - low.position[axis] > largest)
      refuse_table(table, {}, "nodes are more than 100 m apart, and no unit is stated", "write the unit into the titles, e.g. x [mm]");
  }
}

/// Numbers whose unit nothing states are m, unless a remark states another.
void require_no_other_length(const Columns& table) {
  const auto unread = unread_unit(table, [](const Unit& unit) { return unit.same_dimension({1.0, 1, 0, 0}); });
  if (unread)
    refuse_table(table, unread->place, "states the unit '" + unread->unit + "', and the titles of x, y and z state none",
                 "write it into the titles, e.g. x [mm]");
}

std::vector<Node> nodes_of(const Columns& table) {
  const NumberColumn& ids = ids_of(table);
  const std::array<const NumberColumn*, 3> axes = {&column_of(table, {"x"}), &column_of(table, {"y"}), &column_of(table, {"z"})};
  const std::size_t count = ids.values.size();
  std::vector<Node> out(count);
  std::set<std::int64_t> known;
  for (std::size_t i = 0; i < count; ++i) {
    out[i].id = node_of(table, ids, i);
    if (!known.insert(out[i].id).second)
      refuse_table(table, row_of(i), "node " + std::to_string(out[i].id) + " is there twice", "give each node one row");
  }
  std::size_t stated = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const NumberColumn& column = *axes[axis];
    const double unit = meters_per(table, column);
    if (!states_no_unit(column.unit)) ++stated;
    if (column.values.size() != count)
      refuse_table(table, "column " + column.name, "has another length than the nodes", "give each node x, y and z");
    for (std::size_t i = 0; i < count; ++i) {
      out[i].position[axis] = unit * column.values[i];
      if (!std::isfinite(column.values[i])) refuse_table(table, row_of(i), column.name + " is no number", "give each node x, y and z");
    }
  }
  if (stated > 0 && stated < axes.size())
    refuse_table(table, {}, "some of x, y and z have a unit, and the others none",
                 "write the unit into the titles of all three, e.g. x [mm]");
  if (stated == 0 && count > 0) {
    require_no_other_length(table);
    require_size(table, out);
  }
  return out;
}

/// "to", "to2", "to3" …
bool names_end(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.starts_with("to") && std::ranges::all_of(name.substr(2), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<NodeLine> lines_of(const Columns& table) {
  const NumberColumn& ids = ids_of(table);
  std::vector<NodeLine> out;
  for (const NumberColumn& column : table.columns) {
    if (!names_end(column.name)) continue;
    for (std::size_t i = 0; i < std::min(column.values.size(), ids.values.size()); ++i) {
      if (!std::isfinite(column.values[i]) || column.values[i] == 0.0) continue;
      out.push_back({node_of(table, ids, i), node_of(table, column, i)});
    }
  }
  return out;
}

}  // namespace

std::vector<Node> read_node_table(const std::filesystem::path& path) {
  require_regular_file(path);
  return is_universal_file(path) ? read_uff_nodes(path) : nodes_of(read_columns(path));
}

std::vector<NodeLine> read_node_lines(const std::filesystem::path& path) {
  require_regular_file(path);
  return is_universal_file(path) ? read_uff_lines(path) : lines_of(read_columns(path));
}

}  // namespace jointid::frf
