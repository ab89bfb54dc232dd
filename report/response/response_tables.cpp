#include "report/response/response_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/complex.hpp"

namespace jointid::report {
namespace {

using response::HarmonicSolution;

std::string numbers_text(const std::vector<int>& numbers) {
  if (numbers.size() <= 4) return fmt::format("{}", fmt::join(numbers, " "));
  return fmt::format("{} {} … {}", numbers[0], numbers[1], numbers.back());
}

double amplitude(const HarmonicSolution& solution, Eigen::Index row, Eigen::Index dof) {
  return std::abs(solution.response(row, dof));
}

double phase(const HarmonicSolution& solution, Eigen::Index dof) {
  return std::arg(solution.response(tasks::first_row(solution), dof)) * 180.0 / std::numbers::pi;
}

bool any_deviation(const tasks::ResponseResult& run) {
  return std::ranges::any_of(run.levels, [](const tasks::LevelResponse& level) { return !level.deviations.empty(); });
}

std::string multiplier_text(const std::optional<tasks::PointStability>& stability) {
  if (!stability || !stability->known || stability->another) return "–";
  return fmt::format("{:.4f}{}", stability->largest, stability->stable ? "" : " unstable");
}

void add_curve_point(const tasks::CurveRun& curve, double parameter, const HarmonicSolution& point, const std::string& remark,
                     Table& table) {
  const double force = curve.curve.parameter ? curve.curve.force : parameter;
  std::vector<std::string> cells = {number(parameter)};
  for (Eigen::Index dof = 0; dof < point.response.cols(); ++dof) {
    const double size = amplitude(point, tasks::first_row(point), dof);
    cells.insert(cells.end(), {number(size), number(size / force)});
  }
  cells.insert(cells.end(), {number(point.loss.sum()), remark});
  table.add(cells);
}

}  // namespace

Table peaks_table(const tasks::ResponseResult& run) {
  const bool known = any_deviation(run);
  std::vector<Column> columns = {{"force N"}, {"peak Hz"}, {"|X| m"}};
  if (known) columns.push_back({"std dev m"});
  columns.insert(columns.end(), {{"|X|/force m/N"}, {"damping %"}, {"loss J/period"}});
  const bool judged =
      std::ranges::any_of(run.levels, [](const tasks::LevelResponse& level) { return level.peak_stability.has_value(); });
  if (judged) columns.push_back({"|μ|"});
  columns.insert(columns.end(), {{"harmonics", Align::left}, {"", Align::left}});
  Table table(columns);
  for (const tasks::LevelResponse& level : run.levels) {
    std::vector<std::string> cells = {number(level.level)};
    if (level.peak) {
      const HarmonicSolution& peak = *level.peak;
      const double size = amplitude(peak, tasks::first_row(peak), 0);
      cells.push_back(number(hertz(peak.omega)));
      cells.push_back(number(size, level.peak_deviation));
      if (known) cells.push_back(level.peak_deviation ? fmt::format("{:.2g}", *level.peak_deviation) : "–");
      const std::string damping = level.peak_mode ? fmt::format("{:.4g}", 100.0 * level.peak_mode->ratio) : "–";
      cells.insert(cells.end(), {number(size / level.level), damping, number(peak.loss.sum())});
      if (judged) cells.push_back(multiplier_text(level.peak_stability));
      cells.push_back(numbers_text(peak.harmonics));
    } else {
      cells.resize(columns.size() - 1, "–");
    }
    cells.push_back(!level.peak ? "no peak found" : level.refined ? "" : "largest of the points");
    table.add(cells);
  }
  return table;
}

Table points_table(const tasks::ResponseResult& run) {
  const bool known = any_deviation(run);
  std::vector<Column> columns = {{"force N"}, {"Hz"}};
  for (const std::string& dof : run.dofs) {
    columns.push_back({"|X(" + dof + ")| m"});
    if (known) columns.push_back({"std dev"});
    columns.push_back({"phase °"});
  }
  columns.push_back({"loss J/period"});
  const bool judged = std::ranges::any_of(run.levels, [](const tasks::LevelResponse& level) { return !level.stability.empty(); });
  if (judged) columns.push_back({"|μ|"});
  columns.insert(columns.end(), {{"harmonics", Align::left}, {"", Align::left}});
  Table table(columns);
  for (const tasks::LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      const HarmonicSolution& point = level.points[i];
      std::vector<std::string> cells = {number(level.level), number(hertz(point.omega))};
      if (point.converged) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          cells.push_back(number(amplitude(point, tasks::first_row(point), at(dof))));
          if (known) cells.push_back(fmt::format("{:.2g}", level.deviations[i].amplitude(tasks::first_row(point), at(dof))));
          cells.push_back(fmt::format("{:.2f}", phase(point, at(dof))));
        }
        cells.push_back(number(point.loss.sum()));
        if (judged) cells.push_back(level.stability.empty() ? "–" : multiplier_text(level.stability[i]));
      } else {
        cells.resize(columns.size() - 2, "–");
      }
      cells.push_back(numbers_text(point.harmonics));
      cells.push_back(point.converged ? "" : "not converged");
      table.add(cells);
    }
  }
  return table;
}

Table curve_table(const tasks::CurveRun& curve, const tasks::ResponseResult& run, std::size_t most) {
  std::vector<Column> columns = {{curve.name}};
  for (const std::string& dof : run.dofs) columns.insert(columns.end(), {{"|X(" + dof + ")| m"}, {"|X|/force m/N"}});
  columns.insert(columns.end(), {{"loss J/period"}, {"", Align::left}});
  Table table(columns);
  const std::size_t count = curve.found.points.size(), shown = std::min(most, count);
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t at = shown > 1 ? i * (count - 1) / (shown - 1) : 0;
    add_curve_point(curve, curve.found.parameters[at], curve.found.points[at], "", table);
  }
  for (std::size_t i = 0; i < curve.found.peaks.size(); ++i) {
    add_curve_point(curve, curve.found.peak_parameters[i], curve.found.peaks[i], "peak", table);
  }
  return table;
}

std::string curve_remark(const tasks::CurveRun& curve) {
  const std::string force = curve.curve.parameter ? fmt::format(", {:.6g} N", curve.curve.force) : "";
  return fmt::format("{} at {:.6g} Hz", force, curve.curve.frequency_hz);
}

Table equivalents_table(const tasks::ResponseResult& run) {
  std::vector<Column> columns = {{"|Q| m"}};
  for (const std::string& joint : run.joints) columns.insert(columns.end(), {{"k_e(" + joint + ") N/m"}, {"d_e N/m"}});
  const bool modes =
      std::ranges::any_of(run.equivalents, [](const tasks::EquivalentRow& row) { return row.mode || !row.problem.empty(); });
  if (modes) columns.insert(columns.end(), {{"mode Hz"}, {"damping %"}, {"", Align::left}});
  Table table(columns);
  for (const tasks::EquivalentRow& row : run.equivalents) {
    std::vector<std::string> cells = {number(row.amplitude)};
    for (const response::EquivalentJoint& joint : row.joints)
      cells.insert(cells.end(), {number(joint.stiffness), number(joint.damping)});
    if (row.mode) {
      const double loss = row.mode->loss_factor_joints + row.mode->loss_factor_viscous;
      cells.insert(cells.end(), {number(hertz(row.mode->omega)), fmt::format("{:.4g}", 50.0 * loss),
                                 row.mode->converged ? "" : "not converged"});
    } else if (modes) {
      cells.insert(cells.end(), {"–", "–", row.problem});
    }
    table.add(cells);
  }
  return table;
}

Table clamping_table(const tasks::ClampingRun& clamping) {
  std::vector<Column> columns = {{"normal load / that of the laws"}};
  if (clamping.nominal) columns.push_back({"N"});
  columns.insert(columns.end(), {{"peak Hz"}, {"|X| m"}, {"|X|/force m/N"}, {"", Align::left}});
  Table table(columns);
  for (const tasks::ClampedPeak& peak : clamping.peaks) {
    std::vector<std::string> cells = {number(peak.load)};
    if (clamping.nominal) cells.push_back(number(peak.load * *clamping.nominal));
    if (peak.amplitude) {
      const bool least = clamping.best && peak.load == clamping.best->load;
      cells.insert(cells.end(), {number(peak.frequency_hz), number(*peak.amplitude), number(*peak.amplitude / clamping.level),
                                 least ? "least" : (peak.complete ? "" : "some frequencies did not converge")});
    } else {
      cells.insert(cells.end(), {"–", "–", "–", "not converged"});
    }
    table.add(cells);
  }
  return table;
}

std::string clamping_verdict(const tasks::ClampingRun& clamping) {
  const std::string level = fmt::format("{:.6g} N: ", clamping.level);
  if (!clamping.best) return level + "no peak was found under any normal load";
  const tasks::ClampedPeak &best = *clamping.best, &loose = clamping.peaks.front(), &tight = clamping.peaks.back();
  const auto in_newtons = [&](double load) { return clamping.nominal ? fmt::format(" ({:.4g} N)", load * *clamping.nominal) : ""; };
  if (clamping.at_end) {
    return level + fmt::format(
                       "the peak is least at an end of the range, under {:.3g} times the normal load{}. Widen range; if that changes "
                       "nothing, friction does not damp this resonance",
                       best.load, in_newtons(best.load));
  }
  const auto [from, to] = clamping.within_tenth;
  std::string text =
      level + fmt::format(
                  "the peak is least under {:.3g} times the normal load{}, with |X| = {:.4g} m at {:.6g} Hz. It is at most a tenth "
                  "higher from {:.3g}{} to {:.3g}{} times that load",
                  best.load, in_newtons(best.load), *best.amplitude, best.frequency_hz, from, in_newtons(from), to, in_newtons(to));
  if (loose.amplitude && tight.amplitude) {
    text += fmt::format(". At the ends of the range it is {:.3g} and {:.3g} times as high", *loose.amplitude / *best.amplitude,
                        *tight.amplitude / *best.amplitude);
  }
  return text;
}

Table transients_table(const tasks::ResponseResult& run) {
  std::vector<Column> columns = {{"", Align::left}, {"until s"}};
  for (const std::string& dof : run.dofs) columns.push_back({"max |x(" + dof + ")| m"});
  for (const std::string& joint : run.marched) columns.insert(columns.end(), {{"max |q(" + joint + ")| m"}, {"max |f| N"}});
  columns.push_back({"events"});
  Table table(columns);
  for (const tasks::TransientRun& each : run.transients) {
    const response::Transient& motion = each.motion;
    std::vector<std::string> cells = {each.name, number(motion.times.back())};
    for (Eigen::Index i = 0; i < motion.x.cols(); ++i) cells.push_back(number(motion.x.col(i).cwiseAbs().maxCoeff()));
    for (Eigen::Index j = 0; j < motion.q.cols(); ++j) {
      cells.insert(cells.end(), {number(motion.q.col(j).cwiseAbs().maxCoeff()), number(motion.f.col(j).cwiseAbs().maxCoeff())});
    }
    cells.push_back(motion.events > 0 ? std::to_string(motion.events) : "–");
    table.add(cells);
  }
  return table;
}

}  // namespace jointid::report
