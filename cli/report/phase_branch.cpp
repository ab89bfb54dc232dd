#include "cli/report/phase_branch.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace jointid::cli::report {
namespace {

constexpr double full_circle = 360.0;
/// A curve that crosses the end of the period more often is drawn as points.
constexpr std::size_t most_crossings = 12;

/// Best first where several are crossed equally often.
constexpr std::array branch_ends = {180.0, 90.0, -90.0, 135.0, -135.0, 45.0, -45.0, 0.0, 105.0, -105.0, 75.0, -75.0,
                                    120.0, -120.0, 60.0, -60.0, 150.0, -150.0, 30.0, -30.0, 165.0, -165.0, 15.0, -15.0};

/// In (end − 360°, end].
double within_branch(double phase, double end) { return phase - full_circle * std::ceil((phase - end) / full_circle); }

Style pointed(Style style) { return style == Style::reference ? Style::reference_points : Style::points; }

}  // namespace

std::size_t crossings(const std::vector<double>& phase_deg, double end_deg) {
  std::size_t count = 0;
  double before = std::numeric_limits<double>::quiet_NaN();
  for (const double phase : phase_deg) {
    const double here = within_branch(phase, end_deg);
    if (std::abs(here - before) > 0.5 * full_circle) ++count;  // false for NaN
    before = here;
  }
  return count;
}

double branch_end_deg(const std::vector<Series>& phases) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  double best = branch_ends.front();
  for (const double end : branch_ends) {
    std::size_t count = 0;
    for (const Series& series : phases) count += crossings(series.y, end);
    if (count >= least) continue;
    least = count;
    best = end;
  }
  return best;
}

void choose_branch(CurvePlot& phases) {
  const double end = branch_end_deg(phases.series);
  for (Series& series : phases.series) {
    if (crossings(series.y, end) > most_crossings) series.style = pointed(series.style);
    for (double& phase : series.y) phase = within_branch(phase, end);
  }
  phases.period = full_circle;
  phases.y_range = {end - full_circle, end};
}

}  // namespace jointid::cli::report
