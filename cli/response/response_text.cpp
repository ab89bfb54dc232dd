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

bool any_deviation(const ResponseRun& run) {
  return std::ranges::any_of(run.levels, [](const LevelResponse& level) { return !level.deviations.empty(); });
}

std::string peaks_text(const ResponseRun& run) {
  const bool known = any_deviation(run);
  std::vector<Column> columns = {{"force N"}, {"peak Hz"}, {"|X| m"}};
  if (known) columns.push_back({"std dev m"});
  columns.insert(columns.end(), {{"|X|/force m/N"}, {"loss J/period"}, {"harmonics", Align::left}, {"", Align::left}});
  Table table(columns);
  for (const LevelResponse& level : run.levels) {
    std::vector<std::string> cells = {number(level.level)};
    if (level.peak) {
      const HarmonicSolution& peak = *level.peak;
      const double size = amplitude(peak, first_row(peak), 0);
      cells.push_back(number(hertz(peak)));
      cells.push_back(number(size, level.peak_deviation));
      if (known) cells.push_back(level.peak_deviation ? fmt::format("{:.2g}", *level.peak_deviation) : "–");
      cells.insert(cells.end(), {number(size / level.level), number(peak.loss.sum()), numbers_text(peak.harmonics)});
    } else {
      cells.resize(columns.size() - 1, "–");
    }
    cells.push_back(!level.peak ? "no peak found" : level.refined ? "" : "largest of the points");
    table.add(cells);
  }
  return table.text();
}

std::string points_text(const ResponseRun& run) {
  const bool known = any_deviation(run);
  std::vector<Column> columns = {{"force N"}, {"Hz"}};
  for (const std::string& dof : run.dofs) {
    columns.push_back({"|X(" + dof + ")| m"});
    if (known) columns.push_back({"std dev"});
    columns.push_back({"phase °"});
  }
  columns.insert(columns.end(), {{"loss J/period"}, {"harmonics", Align::left}, {"", Align::left}});
  Table table(columns);
  for (const LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      const HarmonicSolution& point = level.points[i];
      std::vector<std::string> cells = {number(level.level), number(hertz(point))};
      if (point.converged) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          cells.push_back(number(amplitude(point, first_row(point), at(dof))));
          if (known) cells.push_back(fmt::format("{:.2g}", level.deviations[i].amplitude(first_row(point), at(dof))));
          cells.push_back(fmt::format("{:.2f}", phase(point, at(dof))));
        }
        cells.push_back(number(point.loss.sum()));
      } else {
        cells.resize(columns.size() - 2, "–");
      }
      cells.push_back(numbers_text(point.harmonics));
      cells.push_back(point.converged ? "" : "not converged");
      table.add(cells);
    }
  }
  return table.text();
}

/// What is left out by the harmonics, the worst of all points.
std::string truncation_text(const ResponseScene& scene, const ResponseRun& run) {
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
  if (scene.harmonics.fixed.empty() && next > scene.harmonics.tolerance) {
    text += fmt::format("that is above the tolerance of {:.1e}: raise largest_harmonic above {}\n", scene.harmonics.tolerance,
                        scene.harmonics.largest);
  }
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
          "{:.6g} N: harmonic balance did not converge at {} of {} frequencies; marching in time may find a response there\n",
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
  const std::string remarks = truncation_text(scene, run) + problems_text(run);
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
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      Json point = point_json(level.points[i], run);
      if (!level.deviations.empty() && level.points[i].converged) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          point["response_deviations"].push_back(harmonics_json(level.deviations[i].parts, at(dof)));
        }
      }
      one["points"].push_back(std::move(point));
    }
    one["peak"] = level.peak ? point_json(*level.peak, run) : Json();
    one["peak_deviation"] = value(level.peak_deviation);
    one["turning_points"] = Json::array();
    for (const HarmonicSolution& turn : level.turning_points) one["turning_points"].push_back(point_json(turn, run));
    out["levels"].push_back(std::move(one));
  }
  return json_text(out);
}

std::string response_csv(const ResponseRun& run) {
  std::string text =
      csv_line({"force [N]", "frequency [Hz]", "harmonic", "dof", "re [m]", "im [m]", "std dev re [m]", "std dev im [m]"});
  for (const LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.points.size(); ++i) {
      const HarmonicSolution& point = level.points[i];
      if (!point.converged) continue;
      for (Eigen::Index n = 0; n < point.response.rows(); ++n) {
        for (std::size_t dof = 0; dof < run.dofs.size(); ++dof) {
          const Complex x = point.response(n, at(dof));
          std::optional<double> re, im;
          if (!level.deviations.empty()) {
            re = level.deviations[i].parts(n, at(dof)).real();
            im = level.deviations[i].parts(n, at(dof)).imag();
          }
          text += csv_line({csv_number(level.level), csv_number(hertz(point)),
                            fmt::format("{}", point.harmonics[static_cast<std::size_t>(n)]), run.dofs[dof], csv_number(x.real()),
                            csv_number(x.imag()), csv_number(re), csv_number(im)});
        }
      }
    }
  }
  return text;
}

}  // namespace jointid::cli
