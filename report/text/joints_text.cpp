#include "report/text/joints_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "base/text.hpp"
#include "report/text/table.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_joints = 60, shown_of_many = 20;
constexpr double least_value = 0.1;  ///< of the largest of its joint, matrix and unit: smaller values count as that

/// Some unknowns of a joint that can be compared in size.
struct SizeGroup {
  std::string unit;
  double largest = 0.0;
};

struct JointRow {
  std::string name;
  std::size_t unknowns = 0, undetermined = 0;
  std::map<std::string, SizeGroup> by_kind;  ///< symbol → its first unit
  std::string worst;
  double worst_error = -1.0;  ///< over the value
};

std::string joint_of(const std::string& unknown) {
  const std::size_t dot = unknown.find('.');
  return dot == std::string::npos ? "" : unknown.substr(0, dot);
}

/// "K" of "left.K(1,2)".
std::string kind_of(const std::string& unknown) { return unknown.substr(unknown.find('.') + 1, 1); }

/// In the order of the unknowns.
std::vector<JointRow> joint_rows(const ident::Solution& solution) {
  std::vector<JointRow> rows;
  std::map<std::string, std::size_t> places;
  std::map<std::pair<std::string, std::string>, double> largest;  // by joint and kind with unit
  const auto group = [](const ident::Estimate& u) { return std::pair(joint_of(u.name), kind_of(u.name) + u.unit); };
  for (const ident::Estimate& unknown : solution.unknowns) {
    double& size = largest[group(unknown)];
    size = std::max(size, std::abs(unknown.value));
  }
  for (const ident::Estimate& unknown : solution.unknowns) {
    const auto [place, added] = places.try_emplace(joint_of(unknown.name), rows.size());
    if (added) rows.push_back({.name = place->first, .by_kind = {}, .worst = {}});
    JointRow& row = rows[place->second];
    ++row.unknowns;
    row.undetermined += unknown.determined ? 0 : 1;
    SizeGroup& of_kind = row.by_kind[kind_of(unknown.name)];
    if (of_kind.unit.empty()) of_kind = {unknown.unit, largest[group(unknown)]};
    const std::optional<double> error = unknown.error();
    if (!error) continue;
    const double share = *error / std::max(std::abs(unknown.value), least_value * largest[group(unknown)]);
    if (share > row.worst_error) {
      row.worst_error = share;
      row.worst = unknown.name;
    }
  }
  return rows;
}

std::string bar(double share) {
  std::string out;
  for (int i = 0; i < static_cast<int>(std::lround(12.0 * share)); ++i) out += "█";
  return out;
}

std::string note(const JointRow& row) {
  if (row.undetermined == row.unknowns) return "not determined by the data";
  return row.undetermined > 0 ? fmt::format("{} not determined by the data", row.undetermined) : "";
}

void keep_the_worst(std::vector<JointRow>& rows) {
  std::ranges::stable_sort(rows, [](const JointRow& a, const JointRow& b) {
    return a.undetermined != b.undetermined ? a.undetermined > b.undetermined : a.worst_error > b.worst_error;
  });
  rows.resize(std::min(rows.size(), shown_of_many));
}

}  // namespace

bool is_shown_by_joint(const ident::Solution& solution) {
  return solution.unknowns.size() > most_unknowns_in_full && !joint_of(solution.unknowns.front().name).empty();
}

std::string joints_text(const ident::Solution& solution) {
  std::vector<JointRow> rows = joint_rows(solution);
  const std::size_t joints = rows.size();
  std::map<std::string, double> largest;
  for (const JointRow& row : rows) {
    for (const auto& [kind, group] : row.by_kind) largest[kind] = std::max(largest[kind], group.largest);
  }
  const auto undetermined = static_cast<std::size_t>(std::ranges::count_if(rows, [](const JointRow& row) { return row.undetermined > 0; }));
  const bool errors = std::ranges::any_of(rows, [](const JointRow& row) { return row.worst_error >= 0.0; });
  const bool many = joints > most_joints;
  if (many) keep_the_worst(rows);
  std::vector<Column> columns = {{"joint", Align::left}, {"unknowns"}};
  for (const auto& [kind, size] : largest) columns.insert(columns.end(), {{"largest " + kind}, {"unit", Align::left}, {"", Align::left}});
  if (errors) columns.insert(columns.end(), {{"worst unknown", Align::left}, {"error / value"}});
  columns.push_back({"", Align::left});
  Table table(std::move(columns));
  for (const JointRow& row : rows) {
    std::vector<std::string> cells = {row.name, fmt::format("{}", row.unknowns)};
    for (const auto& [kind, size] : largest) {
      const auto found = row.by_kind.find(kind);
      const bool there = found != row.by_kind.end();
      cells.insert(cells.end(), {there ? number(found->second.largest) : "", there ? found->second.unit : "",
                                 there && size > 0.0 ? bar(found->second.largest / size) : ""});
    }
    if (errors) cells.insert(cells.end(), {row.worst, row.worst_error >= 0.0 ? percent(row.worst_error) : "–"});
    cells.push_back(note(row));
    table.add(std::move(cells));
  }
  std::string text = fmt::format("\njoints: {}, {} unknowns", joints, solution.unknowns.size());
  if (undetermined > 0) text += fmt::format("; {} joints have unknowns that the data do not determine", undetermined);
  if (many) text += fmt::format("; the {} {}", rows.size(), errors || undetermined > 0 ? "worst" : "first");
  text += "\n" + table.text() + "  every unknown: --csv FILE, or --json FILE with the matrices\n";
  return text;
}

}  // namespace jointid::report
