#include "report/page/phase_branch.hpp"

#include "report/phase_branch.hpp"

namespace jointid::report {
namespace {

constexpr double period_deg = 360.0;
/// A curve that crosses the end of the period more often is drawn as points.
constexpr std::size_t most_crossings = 12;

Style pointed(Style style) { return style == Style::reference ? Style::reference_points : Style::points; }

}  // namespace

void choose_branch(CurvePlot& phases) {
  std::vector<std::vector<double>> curves;
  for (const Series& series : phases.series) curves.push_back(series.y);
  const double end = jointid::report::branch_end_deg(curves);
  for (Series& series : phases.series) {
    if (jointid::report::crossings(series.y, end) > most_crossings) series.style = pointed(series.style);
    for (double& phase : series.y) phase = jointid::report::within_branch(phase, end);
  }
  phases.period = period_deg;
  phases.y_range = {end - period_deg, end};
}

}  // namespace jointid::report
