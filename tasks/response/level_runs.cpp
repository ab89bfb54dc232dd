#include "tasks/response/level_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/complex.hpp"
#include "response/continuation/sweep.hpp"
#include "response/harmonic/left_out.hpp"
#include "response/stability/solution_orbit.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

using response::HarmonicSolution;

constexpr int points_in_loop = 256;

double size_of(const HarmonicSolution& solution) { return std::abs(solution.response(first_row(solution), 0)); }

/// The largest point, and the peak beside it where the structure is known between frequencies.
void find_peak(const response::HarmonicBalance& balance, const ResponseScene& scene, LevelResponse& level) {
  const HarmonicSolution* best = nullptr;
  for (const HarmonicSolution& point : level.points) {
    if (point.converged && (best == nullptr || size_of(point) > size_of(*best))) best = &point;
  }
  if (best == nullptr) return;
  level.peak = *best;
  if (coordinates(scene) == 0 || level.points.size() < 3 || best == &level.points.front() || best == &level.points.back()) return;
  const double width = 2.0 * std::abs(best->omega - (best - 1)->omega) / best->omega;
  const int harmonic = best->harmonics[static_cast<std::size_t>(first_row(*best))];
  auto peak = response::peak_near(balance, *best, level.level, 0, harmonic, std::max(width, 1e-6));
  if (!peak || size_of(*peak) < size_of(*best)) return;
  level.peak = std::move(peak);
  level.refined = true;
}

/// Error bars of harmonics beyond the lines of the files.
void find_left_out(const response::HarmonicBalance& balance, LevelResponse& level) {
  const bool any =
      std::ranges::any_of(level.points, [](const HarmonicSolution& point) { return point.converged && !point.dropped.empty(); });
  if (!any) return;
  for (const HarmonicSolution& point : level.points) {
    level.left_out.push_back(point.converged ? response::left_out(balance, point) : Eigen::MatrixXd());
  }
}

/// Deviations of all points, if the scene or its files tell any error.
void find_deviations(const response::HarmonicBalance& balance, const ResponseScene& scene, LevelResponse& level) {
  std::vector<response::ParameterDeviation> parameters;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const std::vector<double>& deviations = scene.joints[j].deviations;
    for (std::size_t p = 0; p < deviations.size(); ++p) {
      if (deviations[p] > 0.0) parameters.push_back({{j, p}, deviations[p]});
    }
  }
  const bool structure = !level.points.empty() && !balance.structure().errors(level.points.front().omega).empty();
  if (parameters.empty() && !structure) return;
  for (const HarmonicSolution& point : level.points) {
    level.deviations.push_back(point.converged ? response::deviations(balance, point, parameters)
                                               : response::ResponseDeviations{});
  }
  if (level.peak)
    level.peak_deviation = response::deviations(balance, *level.peak, parameters).amplitude(first_row(*level.peak), 0);
}

PointStability stability_of(const response::HarmonicBalance& balance, const Prepared& prepared,
                            const HarmonicSolution& solution) {
  PointStability told;
  if (!solution.converged) return told;
  const response::SolutionStability found = response::stability(*prepared.marched, balance.force(), solution);
  told.known = found.orbit.closed;
  if (!told.known) return told;
  told.stable = found.orbit.stable;
  told.difference = found.difference;
  told.another = found.difference > response::another_orbit;
  told.multipliers.assign(found.orbit.multipliers.begin(), found.orbit.multipliers.end());
  if (!told.multipliers.empty()) told.largest = std::abs(told.multipliers.front());
  for (const std::size_t j : found.residual_force_free) told.residual_force_free.push_back(balance.joints()[j].name);
  return told;
}

void find_stability(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                    const ident::Control& control, LevelResponse& level) {
  if (!scene.stability) return;
  tell(control, fmt::format("stability at {:.6g} N", level.level));
  const auto of = [&](const HarmonicSolution& solution) {
    stop_if(control.interrupted);
    return stability_of(balance, prepared, solution);
  };
  if (level.peak) level.peak_stability = of(*level.peak);
  if (level.points.size() > most_told) return;
  for (const HarmonicSolution& point : level.points) level.stability.push_back(of(point));
}

/// Mode and loops at the peak.
void describe_peak(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                   LevelResponse& level) {
  if (!level.peak) return;
  const HarmonicSolution& peak = *level.peak;
  const int harmonic = peak.harmonics[static_cast<std::size_t>(first_row(peak))];
  if (const auto beside = prepared.beside(harmonic * peak.omega)) {
    level.peak_mode = response::peak_mode(balance, peak, 0, harmonic, *beside);
    if (!prepared.everywhere && !scene.modal_model) level.line_spacing_hz = 0.5 * hertz((*beside)[1] - (*beside)[0]);
  }
  for (std::size_t j = 0; j < balance.joints().size(); ++j) {
    const response::Motion motion(response::Harmonics(peak.harmonics), peak.joint_motion.col(at(j)));
    level.loops.push_back(response::joint_loop(balance.joints()[j], motion, peak.omega, points_in_loop));
  }
}

LevelResponse arc_length(const response::HarmonicBalance& balance, const ResponseScene& scene, double amplitude) {
  const auto [from, to] = *scene.range_hz;
  response::CurveRequest request = {.along = response::Along::frequency, .from = angular(from), .to = angular(to)};
  request.level = amplitude;
  request.longest_step = 2.0 / static_cast<double>(scene.points - 1);
  response::ResponseCurve curve = response::follow_response(balance, request);
  LevelResponse level = {.level = amplitude, .points = std::move(curve.points)};
  level.turning_points = std::move(curve.turning_points);
  level.complete = curve.end == response::CurveEnd::reached;
  for (const HarmonicSolution& peak : curve.peaks) {
    if (!level.peak || size_of(peak) > size_of(*level.peak)) level.peak = peak;
  }
  level.refined = level.peak.has_value();
  return level;
}

}  // namespace

LevelResponse level_response(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                             double amplitude, const std::function<void(const std::vector<HarmonicSolution>&)>& advance,
                             std::vector<HarmonicSolution> begun) {
  if (scene.method == CurveMethod::arc_length) return arc_length(balance, scene, amplitude);
  std::vector<double> omegas;
  for (const double hz : prepared.frequency_hz) omegas.push_back(angular(hz));
  LevelResponse level = {.level = amplitude};
  level.points = response::sweep(balance, omegas, amplitude, advance, std::move(begun));
  find_peak(balance, scene, level);
  return level;
}

void run_levels(const response::HarmonicBalance& balance, const ResponseScene& scene, const Prepared& prepared,
                const ident::Control& control, ResponseResult& run,
                std::vector<HarmonicSolution> begun, const KeepLevels& keep) {
  for (std::size_t i = run.levels.size(); i < scene.levels.size(); ++i) {
    const std::string stage = fmt::format("{:.6g} N", scene.levels[i]);
    const auto advance = [&](const std::vector<HarmonicSolution>& points) {
      tell(control, stage, points.size(), prepared.frequency_hz.size());
      if (keep) keep(run.levels, points);
      stop_if(control.interrupted);
    };
    if (scene.method == CurveMethod::arc_length) tell(control, stage);
    LevelResponse level = level_response(balance, scene, prepared, scene.levels[i], advance, std::exchange(begun, {}));
    find_deviations(balance, scene, level);
    find_left_out(balance, level);
    describe_peak(balance, scene, prepared, level);
    find_stability(balance, scene, prepared, control, level);
    run.levels.push_back(std::move(level));
    if (keep) keep(run.levels, {});
  }
}

}  // namespace jointid::tasks
