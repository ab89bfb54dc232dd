#include "report/response/response_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "report/response/response_tables.hpp"

namespace jointid::report {
namespace {

using response::HarmonicSolution;

/// Largest error bar of the lowest harmonics of all points, in parts of |X|.
double largest_bar(const tasks::ResponseResult& run) {
  double largest = 0.0;
  for (const tasks::LevelResponse& level : run.levels) {
    for (std::size_t i = 0; i < level.left_out.size(); ++i) {
      if (level.left_out[i].size() == 0) continue;
      const Eigen::Index row = tasks::first_row(level.points[i]);
      const Eigen::ArrayXd size = level.points[i].response.row(row).cwiseAbs().transpose();
      largest = std::max(largest, (level.left_out[i].row(row).transpose().array() / size.max(1e-300)).maxCoeff());
    }
  }
  return largest;
}

/// What is left out by the harmonics, the worst of all points.
void add_truncation(const tasks::ResponseScene& scene, const tasks::ResponseResult& run, std::vector<std::string>& remarks) {
  double next = 0.0;
  const response::DroppedHarmonic* worst = nullptr;
  double worst_hz = 0.0;
  for (const tasks::LevelResponse& level : run.levels) {
    for (const HarmonicSolution& point : level.points) {
      if (point.converged) next = std::max(next, point.next);
      for (const response::DroppedHarmonic& dropped : point.dropped) {
        if (worst != nullptr && dropped.motion <= worst->motion) continue;
        worst = &dropped;
        worst_hz = hertz(point.omega);
      }
    }
  }
  if (next > 0.0)
    remarks.push_back(fmt::format("the next harmonics would move the joints by at most {:.1e} of their motion", next));
  if (next > 1.0) {
    remarks.push_back(
        "that is more than their motion itself: a joint so stiff, or so loose, that its motion is rounding; leave it out or "
        "connect its ends rigidly");
  }
  if (scene.harmonics.fixed.empty() && next > scene.harmonics.tolerance) {
    remarks.push_back(fmt::format("that is above the tolerance of {:.1e}: raise largest_harmonic above {}",
                                  scene.harmonics.tolerance, scene.harmonics.largest));
  }
  if (worst != nullptr) {
    remarks.push_back(fmt::format(
        "harmonics beyond the lines of the files are dropped: at most {:.3g} N at harmonic {} of {:.6g} Hz, about {:.3g} m at "
        "the joint",
        worst->force, worst->harmonic, worst_hz, worst->motion));
    remarks.push_back(
        fmt::format("their error bar (H of the nearest line): |X| by at most {:.2g} of its size", largest_bar(run)));
  }
}

/// What shooting found: the unstable, those with residual force, how far the harmonics are from the exact orbits.
void add_stability(const tasks::ResponseResult& run, std::vector<std::string>& remarks) {
  bool any_known = false;
  double difference = 0.0;
  std::vector<std::string> free;
  const auto add = [&](const tasks::PointStability& stability, const HarmonicSolution& at, double level) {
    const std::string place = fmt::format("{:.6g} N, {:.6g} Hz", level, hertz(at.omega));
    if (!stability.known) {
      remarks.push_back(place + ": no exact orbit was found from the solution, its stability is not known");
    } else if (stability.another) {
      remarks.push_back(place + ": the exact orbit that was found is another one, the solution's stability is not known");
    } else {
      any_known = true;
      if (!stability.stable)
        remarks.push_back(fmt::format("{}: unstable, a multiplier has modulus {:.6g}", place, stability.largest));
      difference = std::max(difference, stability.difference);
      for (const std::string& joint : stability.residual_force_free) {
        if (std::ranges::find(free, joint) == free.end()) free.push_back(joint);
      }
    }
  };
  for (const tasks::LevelResponse& level : run.levels) {
    if (level.peak_stability) add(*level.peak_stability, *level.peak, level.level);
    for (std::size_t i = 0; i < level.stability.size(); ++i) {
      if (level.points[i].converged && !(level.peak && level.points[i].omega == level.peak->omega)) {
        add(level.stability[i], level.points[i], level.level);
      }
    }
  }
  if (!any_known) return;
  remarks.push_back(fmt::format(
      "unless stated otherwise, the responses are stable; exact orbits differ from them by at most {:.2g} of the motion",
      difference));
  if (!free.empty()) {
    remarks.push_back(fmt::format(
        "residual force free: {} never slip fully, a multiplier is exactly 1; means depend on the past, harmonics above 0 do "
        "not",
        fmt::join(free, ", ")));
  }
}

std::string why_incomplete(response::TransientMethod method) {
  if (method == response::TransientMethod::exact) return "events are closer than rounding resolves, or the motion diverges";
  if (method == response::TransientMethod::newmark)
    return "the direct iteration of a step does not converge: reduce delta, or take method one";
  return "the motion grows beyond all numbers";
}

/// Ends of curves and of transients that are not those asked for.
void add_further_problems(const tasks::ResponseScene& scene, const tasks::ResponseResult& run,
                          std::vector<std::string>& remarks) {
  for (const tasks::CurveRun& curve : run.curves) {
    for (std::size_t i = 0; i < curve.found.turning_points.size(); ++i) {
      remarks.push_back(fmt::format("the curve along {} turns back at {:.6g}", curve.name, curve.found.turning_parameters[i]));
    }
    if (curve.found.end != response::CurveEnd::reached) {
      remarks.push_back(fmt::format("the curve along {} could not be followed to its end", curve.name));
    }
  }
  for (const tasks::TransientRun& run_of : run.transients) {
    const response::Transient& motion = run_of.motion;
    if (!motion.complete) {
      remarks.push_back(fmt::format("{}: {}; the motion ends at {:.6g} s", run_of.name, why_incomplete(scene.transient->method),
                                    motion.times.back()));
    }
    if (motion.growth > 1.0 || !motion.too_soft.empty()) {
      remarks.push_back(
          fmt::format("{}: Algorithm Two may be boundedly unstable (its character matrix has {:.6g}): plausible and wrong",
                      run_of.name, motion.growth));
    }
  }
}

/// A resonance that is narrower than the distance of the files' lines: its peak stands between them.
void add_narrow_peak(const tasks::LevelResponse& level, std::vector<std::string>& remarks) {
  if (!level.peak || !level.peak_mode || level.points.size() < 3) return;
  const double width = 2.0 * level.peak_mode->ratio * hertz(level.peak_mode->omega), at = level.peak->omega;
  if (width >= level.line_spacing_hz || at == level.points.front().omega || at == level.points.back().omega) return;
  remarks.push_back(
      fmt::format("{:.6g} N: the peak at {:.6g} Hz is {:.2g} Hz wide but the lines of the files are {:.2g} Hz apart. Its height "
                  "between them is not known; `modal_model = true` goes between lines",
                  level.level, hertz(at), width, level.line_spacing_hz));
}

constexpr double no_force = 1e-9;   ///< of the force on the structure: a joint with less does nothing
constexpr double no_motion = 1e-6;  ///< of the largest |X|: a joint that moves less is where the structure does not open it

/// Joints so loose that the parts respond as without them.
void add_loose_joints(const tasks::ResponseResult& run, std::vector<std::string>& remarks) {
  for (std::size_t j = 0; j < run.joints.size(); ++j) {
    bool any = false, loose = true;
    for (const tasks::LevelResponse& level : run.levels) {
      for (const HarmonicSolution& point : level.points) {
        if (!point.converged) continue;
        any = true;
        const auto largest = [](const auto& values) { return values.cwiseAbs().maxCoeff(); };
        loose = loose && largest(point.joint_force.col(at(j))) <= no_force * level.level &&
                largest(point.joint_motion.col(at(j))) >= no_motion * largest(point.response);
      }
    }
    if (!any || !loose) continue;
    remarks.push_back(fmt::format(
        "joint {} takes all the motion: its force stays below {:.0e} of that on the structure, whose parts respond as without "
        "it; look at the units of its law",
        run.joints[j], no_force));
  }
}

void add_problems(const tasks::ResponseScene& scene, const tasks::ResponseResult& run, std::vector<std::string>& remarks) {
  add_loose_joints(run, remarks);
  for (const tasks::LevelResponse& level : run.levels) {
    add_narrow_peak(level, remarks);
    const auto lost = std::ranges::count(level.points, false, &HarmonicSolution::converged);
    if (lost > 0) {
      remarks.push_back(fmt::format(
          "{:.6g} N: harmonic balance did not converge at {} of {} frequencies; {}", level.level, lost, level.points.size(),
          scene.parts.empty() ? "marching in time may find a response there"
                              : "a joint far stiffer than the parts may be softened until the response changes"));
    } else if (!level.complete) {
      remarks.push_back(fmt::format("{:.6g} N: the curve could not be followed to its end", level.level));
    }
    for (const HarmonicSolution& turn : level.turning_points) {
      remarks.push_back(fmt::format(
          "{:.6g} N: the curve turns back at {:.6g} Hz, |X| = {:.6g} m: between two such frequencies there are several "
          "responses",
          level.level, hertz(turn.omega), std::abs(turn.response(tasks::first_row(turn), 0))));
    }
  }
  remarks.insert(remarks.end(), run.doubts.begin(), run.doubts.end());
}

}  // namespace

std::vector<std::string> response_remarks(const tasks::ResponseScene& scene, const tasks::ResponseResult& run) {
  std::vector<std::string> remarks;
  add_truncation(scene, run, remarks);
  add_stability(run, remarks);
  add_problems(scene, run, remarks);
  add_further_problems(scene, run, remarks);
  for (const tasks::ClampingRun& clamping : run.clampings) remarks.push_back(clamping_verdict(clamping));
  return remarks;
}

std::string response_text(const tasks::ResponseScene& scene, const tasks::ResponseResult& run) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  std::size_t points = 0;
  for (const tasks::LevelResponse& level : run.levels) points += level.points.size();
  if (!run.levels.empty())
    text += fmt::format("response of {} to a force at {}, {} joint{}, {} point{}\n\n", run.dofs.front(), scene.force_dof.name,
                        run.joints.size(), run.joints.size() == 1 ? "" : "s", points, points == 1 ? "" : "s");
  if (!run.levels.empty()) text += points <= tasks::most_told ? points_table(run).text() : peaks_table(run).text();
  for (const tasks::CurveRun& curve : run.curves) {
    text += fmt::format("\nalong {}{}\n", curve.name, curve_remark(curve)) + curve_table(curve, run, tasks::most_told / 2).text();
  }
  if (!run.equivalents.empty()) text += "\nequivalent joints\n" + equivalents_table(run).text();
  for (const tasks::ClampingRun& clamping : run.clampings)
    text += fmt::format("\npeak over the normal load, {:.6g} N\n", clamping.level) + clamping_table(clamping).text();
  if (!run.transients.empty()) text += "\nfrom rest\n" + transients_table(run).text();
  const std::vector<std::string> remarks = response_remarks(scene, run);
  for (std::size_t i = 0; i < remarks.size(); ++i) text += (i == 0 ? "\n" : "") + remarks[i] + "\n";
  return text;
}

}  // namespace jointid::report
