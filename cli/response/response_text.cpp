#include "cli/response/response_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/text/json_value.hpp"
#include "cli/text/table.hpp"

namespace jointid::cli {
namespace {

using response::HarmonicSolution;

constexpr std::size_t most_rows = 40;

double hertz(const HarmonicSolution& solution) { return solution.omega / (2.0 * std::numbers::pi); }

std::string numbers_text(const std::vector<int>& numbers) {
  if (numbers.size() <= 4) return fmt::format("{}", fmt::join(numbers, " "));
  return fmt::format("{} {} … {}", numbers[0], numbers[1], numbers.back());
}

double amplitude(const HarmonicSolution& solution, Eigen::Index row, Eigen::Index dof) {
  return std::abs(solution.response(row, dof));
}

double phase(const HarmonicSolution& solution, Eigen::Index dof) {
  return std::arg(solution.response(first_row(solution), dof)) * 180.0 / std::numbers::pi;
}

std::string peaks_text(const ResponseRun& run) {
  Table table(
      {{"force N"}, {"peak Hz"}, {"|X| m"}, {"|X|/force m/N"}, {"loss J/period"}, {"harmonics", Align::left}, {"", Align::left}});
  for (const LevelResponse& level : run.levels) {
    if (!level.peak) {
      table.add({number(level.level), "–", "–", "–", "–", "", "no peak found"});
      continue;
    }
    const HarmonicSolution& peak = *level.peak;
    const double size = amplitude(peak, first_row(peak), 0);
    table.add({number(level.level), number(hertz(peak)), number(size), number(size / level.level), number(peak.loss.sum()),
               numbers_text(peak.harmonics), level.refined ? "" : "largest of the points"});
  }
  return table.text();
}

std::string points_text(const ResponseRun& run) {
  std::vector<Column> columns = {{"force N"}, {"Hz"}};
  for (const std::string& dof : run.dofs) {
    columns.push_back({"|X(" + dof + ")| m"});
    columns.push_back({"phase °"});
  }
  columns.push_back({"loss J/period"});
  columns.push_back({"harmonics", Align::left});
  columns.push_back({"", Align::left});
  Table table(columns);
  for (const LevelResponse& level : run.levels) {
    for (const HarmonicSolution& point : level.points) {
      std::vector<std::string> cells = {number(level.level), number(hertz(point))};
      for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
        cells.push_back(point.converged ? number(amplitude(point, first_row(point), at(dof))) : "–");
        cells.push_back(point.converged ? fmt::format("{:.2f}", phase(point, at(dof))) : "–");
      }
      cells.push_back(point.converged ? number(point.loss.sum()) : "–");
      cells.push_back(numbers_text(point.harmonics));
      cells.push_back(point.converged ? "" : "not converged");
      table.add(cells);
    }
  }
  return table.text();
}

/// What is left out by the harmonics, the worst of all points.
std::string truncation_text(const ResponseRun& run) {
  double next = 0.0;
  std::string text;
  const response::DroppedHarmonic* worst = nullptr;
  double worst_hz = 0.0;
  for (const LevelResponse& level : run.levels) {
    for (const HarmonicSolution& point : level.points) {
      if (point.converged) next = std::max(next, point.next);
      for (const response::DroppedHarmonic& dropped : point.dropped) {
        if (worst != nullptr && dropped.motion <= worst->motion) continue;
        worst = &dropped;
        worst_hz = hertz(point);
      }
    }
  }
  if (next > 0.0) text += fmt::format("the next harmonics would move the joints by at most {:.1e} of their motion\n", next);
  if (worst != nullptr) {
    text += fmt::format(
        "harmonics beyond the lines of the files are dropped: at most {:.3g} N at harmonic {} of {:.6g} Hz, about {:.3g} m at "
        "the joint\n",
        worst->force, worst->harmonic, worst_hz, worst->motion);
  }
  return text;
}

std::string problems_text(const ResponseRun& run) {
  std::string text;
  for (const LevelResponse& level : run.levels) {
    const auto lost = std::ranges::count(level.points, false, &HarmonicSolution::converged);
    if (lost > 0) {
      text += fmt::format(
          "{:.6g} N: harmonic balance did not converge at {} of {} frequencies; joints this stiff need marching in time\n",
          level.level, lost, level.points.size());
    } else if (!level.complete) {
      text += fmt::format("{:.6g} N: the curve could not be followed to its end\n", level.level);
    }
    for (const HarmonicSolution& turn : level.turning_points) {
      text += fmt::format(
          "{:.6g} N: the curve turns back at {:.6g} Hz, |X| = {:.6g} m: between two such frequencies there are several "
          "responses\n",
          level.level, hertz(turn), amplitude(turn, first_row(turn), 0));
    }
  }
  for (const std::string& doubt : run.doubts) text += doubt + "\n";
  return text;
}

Json harmonics_json(const Eigen::MatrixXcd& rows, Eigen::Index column) {
  Json out = Json::array();
  for (Eigen::Index n = 0; n < rows.rows(); ++n) out.push_back({value(rows(n, column).real()), value(rows(n, column).imag())});
  return out;
}

Json point_json(const HarmonicSolution& point, const ResponseRun& run) {
  Json out = {{"frequency", value(hertz(point))}, {"converged", point.converged}};
  if (!point.converged) return out;
  out["harmonics"] = point.harmonics;
  for (std::size_t i = 0; i < run.dofs.size(); ++i) out["responses"].push_back(harmonics_json(point.response, at(i)));
  for (std::size_t j = 0; j < run.joints.size(); ++j) {
    out["joints"].push_back({{"motion", harmonics_json(point.joint_motion, at(j))},
                             {"force", harmonics_json(point.joint_force, at(j))},
                             {"loss", value(point.loss(at(j)))}});
  }
  out["next_harmonics"] = value(point.next);
  out["newton_steps"] = point.steps;
  for (const response::DroppedHarmonic& dropped : point.dropped) {
    out["dropped"].push_back(
        {{"harmonic", dropped.harmonic}, {"force", value(dropped.force)}, {"motion", value(dropped.motion)}});
  }
  return out;
}

}  // namespace

std::string response_text(const ResponseScene& scene, const ResponseRun& run) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  std::size_t points = 0;
  for (const LevelResponse& level : run.levels) points += level.points.size();
  text += fmt::format("response of {} to a force at {}, {} joint{}, {} point{}\n\n", run.dofs.front(), scene.force_dof.name,
                      run.joints.size(), run.joints.size() == 1 ? "" : "s", points, points == 1 ? "" : "s");
  text += points <= most_rows ? points_text(run) : peaks_text(run);
  const std::string remarks = truncation_text(run) + problems_text(run);
  return remarks.empty() ? text : text + "\n" + remarks;
}

std::string response_json(const ResponseScene& scene, const ResponseRun& run) {
  Json out = {{"status", all_converged(run) ? "ok" : "not_converged"},
              {"force_dof", scene.force_dof.name},
              {"dofs", run.dofs},
              {"joints", run.joints},
              {"levels", Json::array()},
              {"doubts", run.doubts}};
  for (const LevelResponse& level : run.levels) {
    Json one = {{"force", level.level}, {"complete", level.complete}, {"points", Json::array()}};
    for (const HarmonicSolution& point : level.points) one["points"].push_back(point_json(point, run));
    one["peak"] = level.peak ? point_json(*level.peak, run) : Json();
    one["turning_points"] = Json::array();
    for (const HarmonicSolution& turn : level.turning_points) one["turning_points"].push_back(point_json(turn, run));
    out["levels"].push_back(std::move(one));
  }
  return json_text(out);
}

std::string response_csv(const ResponseRun& run) {
  std::string text = csv_line({"force [N]", "frequency [Hz]", "harmonic", "dof", "re [m]", "im [m]"});
  for (const LevelResponse& level : run.levels) {
    for (const HarmonicSolution& point : level.points) {
      if (!point.converged) continue;
      for (Eigen::Index n = 0; n < point.response.rows(); ++n) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          const Complex x = point.response(n, at(dof));
          text += csv_line({csv_number(level.level), csv_number(hertz(point)),
                            fmt::format("{}", point.harmonics[static_cast<std::size_t>(n)]), run.dofs[dof], csv_number(x.real()),
                            csv_number(x.imag())});
        }
      }
    }
  }
  return text;
}

}  // namespace jointid::cli
