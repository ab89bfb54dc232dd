#include "report/result/comparison_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "report/text/cost_table.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

using study::Combination;

/// What the thesis's tables hold constant.
std::string frame_of(const study::Way& way) {
  return fmt::format("method {}, equations {}, solver {}", ident::name(way.method), equations_text(way.equations), ident::name(way.solver));
}

std::string short_number(double value) { return std::isfinite(value) ? fmt::format("{:.3g}", value) : "–"; }

std::string range(const Spread& spread) {
  return short_number(spread.low) + " … " + short_number(spread.high);
}

std::vector<Column> way_columns() {
  return {{"method", Align::left}, {"equations", Align::left}, {"weighting", Align::left}, {"Δ"}, {"solver", Align::left}};
}

const Combination* find(const std::vector<const Combination*>& from, weighting::Weighting weighting, double delta) {
  const auto found = std::ranges::find_if(from, [&](const Combination* each) {
    return each->way.weighting == weighting && each->way.delta == delta;
  });
  return found == from.end() ? nullptr : *found;
}

/// Tables 6.6 to 6.11: rows weighting, columns Δ.
std::optional<PairTable> pair_table(const std::vector<const Combination*>& framed, std::size_t matrix) {
  std::set<double> deltas;
  std::vector<weighting::Weighting> weightings;
  for (const Combination* each : framed) {
    deltas.insert(each->way.delta);
    if (std::ranges::find(weightings, each->way.weighting) == weightings.end()) weightings.push_back(each->way.weighting);
  }
  if (deltas.size() < 2) return std::nullopt;
  std::vector<Column> columns = {{"Δ", Align::left}};
  for (const double delta : deltas) columns.push_back({fmt::format("{:g}", delta)});
  Table table(std::move(columns));
  for (const auto weighting : weightings) {
    std::vector<std::string> cells = {weighting::name(weighting)};
    for (const double delta : deltas) {
      const Combination* found = find(framed, weighting, delta);
      cells.push_back(found ? fmt::format("{:.4f} {:.4f}", found->matrices[matrix].rjcf.median,
                                          found->matrices[matrix].arvf.median)
                            : "–");
    }
    table.add(std::move(cells));
  }
  return PairTable{frame_of(framed.front()->way) + "; medians of RJCF ARVF", std::move(table)};
}

}  // namespace

std::vector<std::string> way_cells(const study::Way& way) {
  const std::string regenerated = way.regenerate.any() ? ", regenerated " + ident::name(way.regenerate) : "";
  return {ident::name(way.method) + regenerated, equations_text(way.equations), weighting_text(way.method, way.weighting),
          delta_text(way.method, way.delta), ident::name(way.solver)};
}

std::vector<PairTable> pair_tables(const std::vector<Combination>& all, std::size_t matrix) {
  std::vector<std::string> frames;
  std::vector<PairTable> tables;
  for (const Combination& first : all) {
    const std::string frame = frame_of(first.way);
    if (std::ranges::find(frames, frame) != frames.end()) continue;
    frames.push_back(frame);
    std::vector<const Combination*> framed;
    for (const Combination& each : all) {
      if (frame_of(each.way) == frame) framed.push_back(&each);
    }
    if (auto table = pair_table(framed, matrix)) tables.push_back(std::move(*table));
  }
  return tables;
}

Table figures_table(const std::vector<Combination>& all, std::size_t matrix) {
  std::vector<Column> columns = way_columns();
  for (const char* title : {"RJCF", "5–95 %", "ARVF", "5–95 %", "rms error", "5–95 %", "bias", "ms"}) columns.push_back({title});
  columns.push_back({"front", Align::left});
  Table table(std::move(columns));
  for (const Combination& each : all) {
    const study::MatrixFigures& figures = each.matrices[matrix];
    std::vector<std::string> cells = way_cells(each.way);
    for (const Spread& spread : {figures.rjcf, figures.arvf, figures.rms_relative_error}) {
      cells.insert(cells.end(), {short_number(spread.median), range(spread)});
    }
    cells.insert(cells.end(), {short_number(figures.bias), short_number(1e3 * each.solve_s), figures.on_front ? "*" : ""});
    table.add(std::move(cells));
  }
  return table;
}

Table cost_table(const std::vector<Combination>& all) {
  std::vector<CostRow> rows;
  for (const Combination& each : all) {
    double worst = 0.0;
    for (const study::MatrixFigures& figures : each.matrices) {
      const double error = figures.rms_relative_error.median;
      worst = std::isnan(error) ? error : std::max(worst, error);
    }
    std::vector<std::string> statuses;
    for (const auto& [status, count] : each.statuses) statuses.push_back(fmt::format("{} {}", count, words(ident::name(status))));
    rows.push_back({way_cells(each.way), short_number(worst), each.solve_s, each.accumulator_bytes,
                    fmt::format("{}", fmt::join(statuses, ", "))});
  }
  return cost_table(way_columns(), "rms error", "trials", rows);
}

std::vector<std::string> left_out_lines(const std::vector<study::LeftOut>& left_out) {
  const auto alike = [](const study::LeftOut& one, const study::LeftOut& other) {
    return one.way.method == other.way.method && one.way.equations == other.way.equations && one.reason == other.reason;
  };
  std::vector<std::string> lines;
  for (auto first = left_out.begin(); first != left_out.end();) {
    const auto last = std::find_if_not(first, left_out.end(), [&](const auto& each) { return alike(*first, each); });
    const auto count = last - first;
    const std::string which = count == 1 ? fmt::format("{}", fmt::join(way_cells(first->way), " "))
                                         : fmt::format("{} {}, {} combinations", ident::name(first->way.method),
                                                       equations_text(first->way.equations), count);
    lines.push_back(which + ": " + first->reason);
    first = last;
  }
  return lines;
}

}  // namespace jointid::report
