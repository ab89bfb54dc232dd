#include "cli/response/response_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "base/complex.hpp"
#include "cli/response/response_tables.hpp"

namespace jointid::cli {
namespace {

using response::HarmonicSolution;

/// Largest error bar of the lowest harmonics of all points, in parts of |X|.
double largest_bar(const ResponseRun& run) {
  double largest = 0.0;
  for (const LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.left_out.size(); ++i) {
      if (level.left_out[i].size() == 0) continue;
      const Eigen::Index row = first_row(level.points[i]);
      const Eigen::ArrayXd size = level.points[i].response.row(row).cwiseAbs().transpose();
      largest = std::max(largest, (level.left_out[i].row(row).transpose().array() / size.max(1e-300)).maxCoeff());
    }
  }
  return largest;
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
        worst_hz = hertz(point.omega);
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
    text += fmt::format("their error bar (H of the nearest line): |X| by at most {:.2g} of its size\n", largest_bar(run));
  }
  return text;
}

/// What shooting found: the unstable, those with residual force, how far the harmonics are from the exact orbits.
std::string stability_text(const ResponseRun& run) {
  std::string text;
  double difference = 0.0;
  std::vector<std::string> free;
  const auto add = [&](const PointStability& stability, const HarmonicSolution& at, double level) {
    const std::string place = fmt::format("{:.6g} N, {:.6g} Hz", level, hertz(at.omega));
    if (!stability.known) {
      text += place + ": no exact orbit was found from the solution, its stability is not known\n";
    } else if (stability.another) {
      text += place + ": the exact orbit that was found is another one, the solution's stability is not known\n";
    } else {
      if (!stability.stable) text += fmt::format("{}: unstable, a multiplier has modulus {:.6g}\n", place, stability.largest);
      difference = std::max(difference, stability.difference);
      for (const std::string& joint : stability.residual_force_free) {
        if (std::ranges::find(free, joint) == free.end()) free.push_back(joint);
      }
    }
  };
  bool asked = false;
  for (const LevelResponse& level : run.levels) {
    asked = asked || level.peak_stability;
    if (level.peak_stability) add(*level.peak_stability, *level.peak, level.level);
    for (std::size_t i = 0; i < level.stability.size(); ++i) {
      if (level.points[i].converged && !(level.peak && level.points[i].omega == level.peak->omega)) {
        add(level.stability[i], level.points[i], level.level);
      }
    }
  }
  if (!asked) return text;
  text += fmt::format(
      "where nothing else is said, the responses are stable; exact orbits differ from them by at most {:.2g} of the motion\n",
      difference);
  if (!free.empty()) {
    text += fmt::format(
        "residual force free: {} never slip fully, a multiplier is exactly 1; means depend on the past, harmonics above 0 do "
        "not\n",
        fmt::join(free, ", "));
  }
  return text;
}

/// Ends of curves and of transients that are not those asked for.
std::string further_problems(const ResponseRun& run) {
  std::string text;
  for (const CurveRun& curve : run.curves) {
    for (std::size_t i = 0; i < curve.found.turning_points.size(); ++i) {
      text += fmt::format("the curve along {} turns back at {:.6g}\n", curve.name, curve.found.turning_parameters[i]);
    }
    if (curve.found.end != response::CurveEnd::reached) {
      text += fmt::format("the curve along {} could not be followed to its end\n", curve.name);
    }
  }
  for (const TransientRun& run_of : run.transients) {
    const response::Transient& motion = run_of.motion;
    if (!motion.complete) {
      text += fmt::format("{}: events come closer to each other than numbers can tell; the motion ends at {:.6g} s\n",
                          run_of.name, motion.times.back());
    }
    if (motion.growth > 1.0 || !motion.too_soft.empty()) {
      text += fmt::format("{}: Algorithm Two may be boundedly unstable (its character matrix has {:.6g}): plausible and wrong\n",
                          run_of.name, motion.growth);
    }
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
          level.level, hertz(turn.omega), std::abs(turn.response(first_row(turn), 0)));
    }
  }
  for (const std::string& doubt : run.doubts) text += doubt + "\n";
  return text;
}

}  // namespace

std::vector<std::string> response_remarks(const ResponseScene& scene, const ResponseRun& run) {
  std::istringstream all(truncation_text(scene, run) + stability_text(run) + problems_text(run) + further_problems(run));
  std::vector<std::string> remarks;
  for (std::string line; std::getline(all, line);) remarks.push_back(line);
  return remarks;
}

std::string response_text(const ResponseScene& scene, const ResponseRun& run) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  std::size_t points = 0;
  for (const LevelResponse& level : run.levels) points += level.points.size();
  if (!run.levels.empty())
    text += fmt::format("response of {} to a force at {}, {} joint{}, {} point{}\n\n", run.dofs.front(), scene.force_dof.name,
                        run.joints.size(), run.joints.size() == 1 ? "" : "s", points, points == 1 ? "" : "s");
  if (!run.levels.empty()) text += points <= most_told ? points_table(run).text() : peaks_table(run).text();
  for (const CurveRun& curve : run.curves) {
    text += fmt::format("\nalong {}{}\n", curve.name, curve_remark(curve)) + curve_table(curve, run, most_told / 2).text();
  }
  if (!run.equivalents.empty()) text += "\nequivalent joints\n" + equivalents_table(run).text();
  if (!run.transients.empty()) text += "\nfrom rest\n" + transients_table(run).text();
  const std::vector<std::string> remarks = response_remarks(scene, run);
  for (std::size_t i = 0; i < remarks.size(); ++i) text += (i == 0 ? "\n" : "") + remarks[i] + "\n";
  return text;
}

}  // namespace jointid::cli
