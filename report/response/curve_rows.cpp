#include "report/response/curve_rows.hpp"

#include <fmt/format.h>

#include "base/complex.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

using response::HarmonicSolution;

/// `first`: what all rows of the solution share.
void add_solution(const HarmonicSolution& at_point, const CurveRow& first, std::vector<CurveRow>& rows) {
  for (Eigen::Index n = 0; n < at_point.response.rows(); ++n) {
    for (Eigen::Index dof = 0; dof < at_point.response.cols(); ++dof) {
      CurveRow& row = rows.emplace_back(first);
      row.frequency_hz = hertz(at_point.omega);
      row.harmonic = at_point.harmonics[static_cast<std::size_t>(n)];
      row.dof = static_cast<std::size_t>(dof);
      row.x = at_point.response(n, dof);
      row.loss = at_point.loss.sum();
    }
  }
}

void add_places(const tasks::CurveRun& curve, const std::vector<HarmonicSolution>& solutions,
                const std::vector<double>& parameters, CurveRow first, std::vector<CurveRow>& rows) {
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    first.parameter = parameters[i];
    first.force = curve.curve.parameter ? curve.curve.force : parameters[i];
    add_solution(solutions[i], first, rows);
  }
}

}  // namespace

std::vector<std::string> curve_names(const tasks::ResponseResult& run) {
  std::vector<std::string> names = {"peaks over force N"};
  for (const tasks::CurveRun& curve : run.curves) names.push_back(curve.name);
  return names;
}

std::vector<CurveRow> curve_rows(const tasks::ResponseResult& run) {
  std::vector<CurveRow> rows;
  for (const tasks::LevelResponse& level : run.levels) {
    if (!level.peak) continue;
    CurveRow first = {.place = CurvePlace::peak, .parameter = level.level, .force = level.level, .x = {}};
    if (level.peak_mode) first.damping = level.peak_mode->ratio;
    add_solution(*level.peak, first, rows);
  }
  for (std::size_t c = 0; c < run.curves.size(); ++c) {
    const response::ResponseCurve& found = run.curves[c].found;
    CurveRow first = {.curve = c + 1, .x = {}};
    add_places(run.curves[c], found.points, found.parameters, first, rows);
    first.place = CurvePlace::turning_point;
    add_places(run.curves[c], found.turning_points, found.turning_parameters, first, rows);
    first.place = CurvePlace::peak;
    add_places(run.curves[c], found.peaks, found.peak_parameters, first, rows);
  }
  return rows;
}

std::string curves_csv(const tasks::ResponseResult& run) {
  const std::vector<std::string> names = curve_names(run);
  std::string text = csv_line({"curve", "place", "parameter", "force [N]", "frequency [Hz]", "harmonic", "dof", "re [m]",
                               "im [m]", "loss [J]", "damping"});
  for (const CurveRow& row : curve_rows(run)) {
    text += csv_line({names[row.curve], std::string(curve_places[static_cast<std::size_t>(row.place)]), csv_number(row.parameter),
                      csv_number(row.force), csv_number(row.frequency_hz), fmt::format("{}", row.harmonic), run.dofs[row.dof],
                      csv_number(row.x.real()), csv_number(row.x.imag()), csv_number(row.loss), csv_number(row.damping)});
  }
  return text;
}

}  // namespace jointid::report
