#include "report/response/response_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/complex.hpp"
#include "report/decimate.hpp"
#include "report/page/limits.hpp"

namespace jointid::report {
namespace {

using response::HarmonicSolution;
using Values = std::vector<double>;

constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

std::string level_name(const tasks::LevelResponse& level) { return fmt::format("{:.6g} N", level.level); }

/// X_n of a response; NaN where the point has no answer or no such harmonic.
Complex amplitude(const HarmonicSolution& point, int harmonic, Eigen::Index dof) {
  const auto place = std::ranges::find(point.harmonics, harmonic);
  if (!point.converged || place == point.harmonics.end()) return {not_there, not_there};
  return point.response(place - point.harmonics.begin(), dof);
}

int lowest_harmonic(const HarmonicSolution& point) { return point.harmonics[static_cast<std::size_t>(tasks::first_row(point))]; }

Complex lowest(const HarmonicSolution& point, Eigen::Index dof) { return amplitude(point, lowest_harmonic(point), dof); }

/// Whether all levels have the same ascending frequencies, as sweeps do and curves round turning points do not.
bool is_sweep(const tasks::ResponseResult& run) {
  return std::ranges::all_of(run.levels, [&](const tasks::LevelResponse& level) {
    return std::ranges::equal(level.points, run.levels.front().points, {}, &HarmonicSolution::omega, &HarmonicSolution::omega) &&
           std::ranges::is_sorted(level.points, {}, &HarmonicSolution::omega);
  });
}

CurvePlot over(const std::string& title, Axis x, Axis y, const Values& x_values, std::vector<Series> series) {
  std::vector<Values> curves;
  for (const Series& one : series) curves.push_back(one.y);
  const std::vector<std::size_t> kept = keep_peaks(curves, most_points);
  for (Series& one : series) one.y = picked(one.y, kept);
  return {title, std::move(x), std::move(y), picked(x_values, kept), std::move(series), {}, {}, {}};
}

template <class Value>
std::vector<Series> series_of_levels(const tasks::ResponseResult& run, const Value& value) {
  std::vector<Series> series;
  for (const tasks::LevelResponse& level : run.levels) {
    Series one{level_name(level), {}, Style::line};
    for (const HarmonicSolution& point : level.points) one.y.push_back(value(level, point));
    series.push_back(std::move(one));
  }
  return series;
}

Values frequencies(const tasks::LevelResponse& level) {
  Values hz;
  for (const HarmonicSolution& point : level.points) hz.push_back(hertz(point.omega));
  return hz;
}

Choice sweep_choice(const tasks::ResponseResult& run, std::size_t dof) {
  const Values hz = frequencies(run.levels.front());
  const Axis x = {"frequency (Hz)", false};
  const auto size = [&](const tasks::LevelResponse& level, const HarmonicSolution& point) {
    return std::abs(lowest(point, at(dof))) / level.level;
  };
  const auto angle = [&](const tasks::LevelResponse&, const HarmonicSolution& point) {
    const Complex value = lowest(point, at(dof));
    return std::isnan(value.real()) ? not_there : std::arg(value) * 180.0 / std::numbers::pi;
  };
  CurvePlot phase = over("Phase", x, {"phase (°)", false}, hz, series_of_levels(run, angle));
  phase.period = 360.0;
  return {
      run.dofs[dof],
      {over("|X|/force at " + run.dofs[dof], x, {"|X|/force (m/N)", true}, hz, series_of_levels(run, size)), std::move(phase)}};
}

Choice arc_choice(const tasks::ResponseResult& run, std::size_t dof) {
  ScatterPlot plot{"|X|/force at " + run.dofs[dof], {"frequency (Hz)", false}, {"|X|/force (m/N)", true}, {}, {}};
  PointGroup turns{"turning points", {}};
  for (const tasks::LevelResponse& level : run.levels) {
    PointGroup group{level_name(level), {}};
    const auto add = [&](const HarmonicSolution& point, PointGroup& to) {
      if (point.converged)
        to.points.push_back({hertz(point.omega), std::abs(lowest(point, at(dof))) / level.level, level_name(level)});
    };
    for (const HarmonicSolution& point : level.points) add(point, group);
    for (const HarmonicSolution& point : level.turning_points) add(point, turns);
    plot.groups.push_back(std::move(group));
  }
  if (!turns.points.empty()) plot.groups.push_back(std::move(turns));
  return {run.dofs[dof], {std::move(plot)}};
}

ScatterPlot loop_plot(const std::string& title) { return {title, {"displacement (m)", false}, {"force (N)", false}, {}, {}}; }

PointGroup loop_points(const std::string& name, const Eigen::VectorXd& q, const Eigen::VectorXd& f, Eigen::Index most) {
  PointGroup group{name, {}};
  const Eigen::Index step = std::max<Eigen::Index>(1, q.size() / most);
  for (Eigen::Index i = 0; i < q.size(); i += step) group.points.push_back({q(i), f(i), name});
  return group;
}

}  // namespace

PlotGroup level_plots(const tasks::ResponseResult& run) {
  PlotGroup group{"response", {}};
  if (run.levels.empty() || run.levels.front().points.size() < 2) return group;
  const bool sweep = is_sweep(run);
  for (std::size_t dof = 0; dof < run.dofs.size(); ++dof)
    group.choices.push_back(sweep ? sweep_choice(run, dof) : arc_choice(run, dof));
  return group;
}

PlotGroup harmonic_plots(const tasks::ResponseResult& run) {
  PlotGroup group{"level", {}};
  if (run.levels.empty() || run.levels.front().points.size() < 2 || !is_sweep(run)) return group;
  for (const tasks::LevelResponse& level : run.levels) {
    std::vector<int> numbers;
    for (const HarmonicSolution& point : level.points) {
      for (const int n : point.harmonics) {
        if (std::ranges::find(numbers, n) == numbers.end()) numbers.push_back(n);
      }
    }
    std::ranges::sort(numbers);
    std::vector<Series> series;
    for (const int n : numbers) {
      if (series.size() == most_frfs) break;
      Series one{fmt::format("n = {}", n), {}, Style::line};
      for (const HarmonicSolution& point : level.points) {
        const double size = std::abs(amplitude(point, n, 0));
        one.y.push_back(size > 0.0 ? size : not_there);
      }
      series.push_back(std::move(one));
    }
    group.choices.push_back({level_name(level),
                             {over("|X_n| at " + run.dofs.front(), {"frequency (Hz)", false}, {"|X_n| (m)", true},
                                   frequencies(level), std::move(series))}});
  }
  return group;
}

PlotGroup backbone_plots(const tasks::ResponseResult& run) {
  std::vector<const tasks::LevelResponse*> levels;
  for (const tasks::LevelResponse& level : run.levels) {
    if (level.peak && level.peak_mode) levels.push_back(&level);
  }
  if (levels.size() < 2) return {"", {}};
  std::ranges::sort(levels, {}, &tasks::LevelResponse::level);
  Values force, hz, damping;
  for (const tasks::LevelResponse* level : levels) {
    force.push_back(level->level);
    hz.push_back(hertz(level->peak->omega));
    damping.push_back(100.0 * level->peak_mode->ratio);
  }
  const Axis x = {"force (N)", true};
  return {"",
          {{"",
            {over("Peak frequency", x, {"frequency (Hz)", false}, force, {{"peak", hz, Style::line}}),
             over("Damping of the peak", x, {"of critical (%)", false}, force, {{"damping", damping, Style::line}})}}}};
}

PlotGroup loop_plots(const tasks::ResponseResult& run) {
  PlotGroup group{"joint", {}};
  for (std::size_t j = 0; j < run.joints.size(); ++j) {
    ScatterPlot plot = loop_plot("Loops of " + run.joints[j] + " at the peaks");
    for (const tasks::LevelResponse& level : run.levels) {
      if (j < level.loops.size())
        plot.groups.push_back(loop_points(level_name(level), level.loops[j].displacement, level.loops[j].force, 256));
    }
    if (!plot.groups.empty()) group.choices.push_back({run.joints[j], {std::move(plot)}});
  }
  return group;
}

PlotGroup curve_plots(const tasks::ResponseResult& run) {
  PlotGroup group{"curve", {}};
  for (const tasks::CurveRun& curve : run.curves) {
    ScatterPlot plot{"|X| at " + run.dofs.front(), {curve.name, false}, {"|X| (m)", true}, {}, {}};
    const auto add = [&](const std::string& name, const Values& parameters, const std::vector<HarmonicSolution>& points) {
      PointGroup one{name, {}};
      for (std::size_t i = 0; i < points.size(); ++i) one.points.push_back({parameters[i], std::abs(lowest(points[i], 0)), name});
      if (!points.empty()) plot.groups.push_back(std::move(one));
    };
    add("curve", curve.found.parameters, curve.found.points);
    add("peaks", curve.found.peak_parameters, curve.found.peaks);
    add("turning points", curve.found.turning_parameters, curve.found.turning_points);
    if (!plot.groups.empty()) group.choices.push_back({curve.name, {std::move(plot)}});
  }
  return group;
}

PlotGroup equivalent_plots(const tasks::ResponseResult& run) {
  if (run.equivalents.size() < 2) return {"", {}};
  std::vector<const tasks::EquivalentRow*> rows;
  for (const tasks::EquivalentRow& row : run.equivalents) rows.push_back(&row);
  std::ranges::sort(rows, {}, &tasks::EquivalentRow::amplitude);
  Values amplitudes, hz;
  std::vector<Series> stiffness, damping;
  for (const std::string& joint : run.joints) {
    stiffness.push_back({joint, {}, Style::line});
    damping.push_back({joint, {}, Style::line});
  }
  bool any = false;
  for (const tasks::EquivalentRow* row : rows) {
    amplitudes.push_back(row->amplitude);
    for (std::size_t j = 0; j < run.joints.size(); ++j) {
      stiffness[j].y.push_back(row->joints[j].stiffness);
      damping[j].y.push_back(row->joints[j].damping);
    }
    any = any || row->mode;
    hz.push_back(row->mode ? hertz(row->mode->omega) : not_there);
  }
  const Axis x = {"amplitude (m)", true};
  Choice choice{"",
                {over("Equivalent stiffness", x, {"k_e (N/m)", false}, amplitudes, std::move(stiffness)),
                 over("Equivalent damping", x, {"d_e (N/m)", false}, amplitudes, std::move(damping))}};
  if (any) choice.plots.emplace_back(over("Mode", x, {"frequency (Hz)", false}, amplitudes, {{"mode", hz, Style::line}}));
  return {"", {std::move(choice)}};
}

PlotGroup clamping_plots(const tasks::ResponseResult& run) {
  if (run.clampings.empty()) return {"", {}};
  ScatterPlot plot{
      "Peak |X|/force at " + run.dofs.front(), {"normal load / that of the laws", true}, {"|X|/force (m/N)", true}, {}, {}};
  for (const tasks::ClampingRun& clamping : run.clampings) {
    PointGroup group{fmt::format("{:.6g} N", clamping.level), {}};
    for (const tasks::ClampedPeak& peak : clamping.peaks) {
      if (!peak.amplitude) continue;
      group.points.push_back({peak.load, *peak.amplitude / clamping.level, fmt::format("{:.6g} Hz", peak.frequency_hz)});
    }
    plot.groups.push_back(std::move(group));
  }
  return {"", {{"", {std::move(plot)}}}};
}

PlotGroup transient_plots(const tasks::ResponseResult& run) {
  PlotGroup group{"motion", {}};
  for (const tasks::TransientRun& each : run.transients) {
    const response::Transient& motion = each.motion;
    Choice choice{each.name, {}};
    std::vector<Series> series;
    for (std::size_t i = 0; i < run.dofs.size(); ++i) {
      const Eigen::VectorXd x = motion.x.col(at(i));
      series.push_back({run.dofs[i], Values(x.begin(), x.end()), Style::line});
    }
    choice.plots.emplace_back(over("Motion", {"time (s)", false}, {"x (m)", false}, motion.times, std::move(series)));
    for (std::size_t j = 0; j < run.marched.size(); ++j) {
      ScatterPlot plot = loop_plot("Path of " + run.marched[j]);
      plot.groups.push_back(loop_points(each.name, motion.q.col(at(j)), motion.f.col(at(j)), 1000));
      choice.plots.emplace_back(std::move(plot));
    }
    group.choices.push_back(std::move(choice));
  }
  return group;
}

}  // namespace jointid::report
