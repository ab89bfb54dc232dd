#include "report/result/comparison_plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/result/comparison_tables.hpp"

namespace jointid::report {
namespace {

using study::Combination;

constexpr std::size_t method = 0, equations = 1, weighting = 2, delta = 3, solver = 4;  ///< of way_cells()

/// way_cells(), to be read without titles; empty for what a method does not have.
std::vector<std::string> choices_of(const Combination& combination) {
  std::vector<std::string> cells = way_cells(combination.way);
  cells[method] = "method " + cells[method];
  cells[delta] = "Δ " + cells[delta];
  if (!ident::weighs_equations(combination.way.method)) cells[weighting] = cells[delta] = "";
  return cells;
}

/// The choices that differ between combinations; the weighting when none does.
std::vector<std::size_t> differing(const std::vector<Combination>& combinations) {
  std::vector<std::size_t> out;
  for (const std::size_t choice : {weighting, method, equations, delta, solver}) {
    const auto differs = [&](const Combination& each) {
      return choices_of(each)[choice] != choices_of(combinations.front())[choice];
    };
    if (std::ranges::any_of(combinations, differs)) out.push_back(choice);
  }
  return out.empty() ? std::vector{weighting} : out;
}

std::string label_of(const Combination& combination, const std::vector<std::size_t>& named) {
  const std::vector<std::string> choices = choices_of(combination);
  std::vector<std::string> words;
  for (const std::size_t choice : named) {
    if (!choices[choice].empty()) words.push_back(choices[choice]);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

PointGroup& group_of(const std::string& name, ScatterPlot& plot) {
  const auto found = std::ranges::find(plot.groups, name, &PointGroup::name);
  return found != plot.groups.end() ? *found : plot.groups.emplace_back(PointGroup{name, {}});
}

/// Logarithmic when the values are positive and over more than a decade.
bool wants_log(const ScatterPlot& plot, double Point::*coordinate) {
  double least = HUGE_VAL, greatest = 0.0;
  for (const PointGroup& group : plot.groups) {
    for (const Point& point : group.points) {
      least = std::min(least, point.*coordinate);
      greatest = std::max(greatest, point.*coordinate);
    }
  }
  return least > 0.0 && greatest > 10.0 * least;
}

}  // namespace

std::pair<double, double> point_of(const Combination& combination, std::size_t matrix) {
  return {1e3 * combination.solve_s, combination.matrices[matrix].rms_relative_error.median};
}

ScatterPlot error_against_time(const std::vector<Combination>& combinations, std::size_t matrix) {
  const std::vector<std::size_t> named = differing(combinations);
  ScatterPlot plot;
  plot.title = "Error against run time";
  plot.front_name = "Pareto front";
  for (const Combination& each : combinations) {
    const study::MatrixFigures& figures = each.matrices[matrix];
    const auto [time_ms, error] = point_of(each, matrix);
    if (!std::isfinite(error)) continue;
    const Point point{time_ms, error, label_of(each, named)};
    group_of(choices_of(each)[named.front()], plot).points.push_back(point);
    if (figures.on_front) plot.front.push_back(point);
  }
  std::ranges::sort(plot.front, {}, &Point::x);
  plot.x = {"time of one solution (ms)", wants_log(plot, &Point::x)};
  plot.y = {"rms relative error (median)", wants_log(plot, &Point::y)};
  return plot;
}

}  // namespace jointid::report
