#include "report/text/joints_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_joints = 60, shown_of_many = 20;
constexpr double least_value = 0.1;  ///< of the largest of its joint, matrix and unit: smaller values count as that

std::string joint_of(const std::string& unknown) {
  const std::size_t dot = unknown.find('.');
  return dot == std::string::npos ? "" : unknown.substr(0, dot);
}

/// "K" of "left.K(1,2)".
std::string kind_of(const std::string& unknown) { return unknown.substr(unknown.find('.') + 1, 1); }

std::string bar(double share) {
  std::string out;
  for (int i = 0; i < static_cast<int>(std::lround(12.0 * share)); ++i) out += "█";
  return out;
}

std::string note(const JointSummary& row) {
  if (row.undetermined == row.unknowns) return "not determined by the data";
  return row.undetermined > 0 ? fmt::format("{} not determined by the data", row.undetermined) : "";
}

void keep_the_worst(std::vector<JointSummary>& rows) {
  std::ranges::stable_sort(rows, [](const JointSummary& a, const JointSummary& b) {
    return a.undetermined != b.undetermined ? a.undetermined > b.undetermined : a.worst_error > b.worst_error;
  });
  rows.resize(std::min(rows.size(), shown_of_many));
}

}  // namespace

bool is_shown_by_joint(const ident::Solution& solution) {
  return solution.unknowns.size() > most_unknowns_in_full && !joint_of(solution.unknowns.front().name).empty();
}

std::vector<JointSummary> joint_summaries(const ident::Solution& solution) {
  std::vector<JointSummary> rows;
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
    JointSummary& row = rows[place->second];
    ++row.unknowns;
    row.undetermined += unknown.determined ? 0 : 1;
    JointSummary::Size& of_kind = row.by_kind[kind_of(unknown.name)];
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

namespace {

/// Those that are shown, and what is the same for all.
struct ShownJoints {
  std::vector<JointSummary> rows;
  std::size_t joints = 0, undetermined = 0;
  std::map<std::string, double> largest;  ///< by kind
  bool errors = false;

  bool are_chosen() const { return rows.size() < joints; }
};

ShownJoints shown_joints(const ident::Solution& solution) {
  ShownJoints out{.rows = joint_summaries(solution), .largest = {}};
  out.joints = out.rows.size();
  for (const JointSummary& row : out.rows) {
    for (const auto& [kind, size] : row.by_kind) out.largest[kind] = std::max(out.largest[kind], size.largest);
    out.undetermined += row.undetermined > 0 ? 1 : 0;
    out.errors = out.errors || row.worst_error >= 0.0;
  }
  if (out.joints > most_joints) keep_the_worst(out.rows);
  return out;
}

std::string head_of(const ident::Solution& solution, const ShownJoints& shown) {
  std::string text = fmt::format("{} joints, {} unknowns", shown.joints, solution.unknowns.size());
  if (shown.undetermined > 0) text += fmt::format("; {} with unknowns that the data do not determine", shown.undetermined);
  if (shown.are_chosen()) text += fmt::format("; the {} {}", shown.rows.size(), shown.errors || shown.undetermined > 0 ? "worst" : "first");
  return text;
}

Table table_of(const ShownJoints& shown) {
  std::vector<Column> columns = {{"joint", Align::left}, {"unknowns"}};
  for (const auto& [kind, size] : shown.largest)
    columns.insert(columns.end(), {{"largest " + kind}, {"unit", Align::left}, {"", Align::left}});
  if (shown.errors) columns.insert(columns.end(), {{"worst unknown", Align::left}, {"error / value"}});
  columns.push_back({"", Align::left});
  Table table(std::move(columns));
  for (const JointSummary& row : shown.rows) {
    std::vector<std::string> cells = {row.name, fmt::format("{}", row.unknowns)};
    for (const auto& [kind, size] : shown.largest) {
      const auto found = row.by_kind.find(kind);
      const bool there = found != row.by_kind.end();
      cells.insert(cells.end(), {there ? number(found->second.largest) : "", there ? found->second.unit : "",
                                 there && size > 0.0 ? bar(found->second.largest / size) : ""});
    }
    if (shown.errors) cells.insert(cells.end(), {row.worst, row.worst_error >= 0.0 ? percent(row.worst_error) : "–"});
    cells.push_back(note(row));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

std::string joints_head(const ident::Solution& solution) { return head_of(solution, shown_joints(solution)); }

Table joints_table(const ident::Solution& solution) { return table_of(shown_joints(solution)); }

std::string joints_text(const ident::Solution& solution) {
  const ShownJoints shown = shown_joints(solution);
  return "\n" + head_of(solution, shown) + "\n" + table_of(shown).text() +
         "  every unknown: --csv FILE, or --json FILE with the matrices\n";
}

}  // namespace jointid::report
