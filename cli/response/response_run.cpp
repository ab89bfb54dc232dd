#include "cli/response/response_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "cli/text/interrupt.hpp"
#include "dense/eigen.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "response/continuation/response_curve.hpp"
#include "response/continuation/sweep.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::cli {
namespace {

using response::HarmonicSolution;

constexpr double active = 0.02;  ///< share of |G| by which −Im G may be negative before it is told

/// The structure of a scene and the frequencies to be computed, Hz.
struct Prepared {
  std::shared_ptr<const response::Receptance> structure;
  std::vector<double> frequency_hz;
  std::vector<std::string> doubts;
};

Prepared from_matrices(const ResponseScene& scene) {
  const Eigen::Index n = scene.structure->mass.rows();
  Eigen::MatrixXd joints = Eigen::MatrixXd::Zero(n, at(scene.joints.size())), force = Eigen::MatrixXd::Zero(n, 1);
  Eigen::MatrixXd responses = Eigen::MatrixXd::Zero(n, at(scene.responses.size()));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    joints(scene.joints[j].positive.coordinate, at(j)) += 1.0;
    if (scene.joints[j].negative) joints(scene.joints[j].negative->coordinate, at(j)) -= 1.0;
  }
  for (std::size_t r = 0; r < scene.responses.size(); ++r) responses(scene.responses[r].coordinate, at(r)) = 1.0;
  force(scene.force_dof.coordinate, 0) = 1.0;
  Prepared prepared = {
      std::make_shared<response::MatrixReceptance>(*scene.structure, joints, responses, force), scene.values_hz, {}};
  if (scene.range_hz && scene.method == CurveMethod::sweep) {
    const auto [from, to] = *scene.range_hz;
    for (std::size_t i = 0; i < scene.points; ++i) {
      prepared.frequency_hz.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(scene.points - 1));
    }
  }
  return prepared;
}

/// Lines at which the parts would feed a joint with energy: −Im WᵀHW has a negative eigenvalue.
std::vector<std::string> passivity_doubts(const response::FrfReceptance& structure, const std::vector<double>& frequency_hz) {
  std::size_t lines = 0;
  double first = 0.0;
  for (const double hz : frequency_hz) {
    const Eigen::MatrixXcd g = structure.at(angular(hz)).topLeftCorner(structure.joints(), structure.joints());
    const Eigen::MatrixXd lost = -0.5 * (g.imag() + g.imag().transpose());
    if (hz == 0.0 || dense::symmetric_eigenvalues(lost).minCoeff() >= -active * g.cwiseAbs().maxCoeff()) continue;
    if (lines++ == 0) first = hz;
  }
  if (lines == 0) return {};
  return {
      fmt::format("the FRFs at the joints are not passive on {} of {} lines (−Im H < 0), first at {:.6g} Hz: `jointid check` "
                  "finds flipped or "
                  "late channels",
                  lines, frequency_hz.size(), first)};
}

Prepared from_files(const ResponseScene& scene) {
  frf::FrfSystem parts("[data] parts", ident::open_all(scene.parts), frf::Composition::uncoupled, scene.reciprocity);
  std::vector<response::JointEnds> joints;
  std::vector<frf::Dof> responses;
  for (const SceneJoint& joint : scene.joints) {
    joints.push_back({joint.positive.dof, joint.negative ? std::optional(joint.negative->dof) : std::nullopt});
  }
  for (const SceneDof& dof : scene.responses) responses.push_back(dof.dof);
  const auto structure =
      std::make_shared<response::FrfReceptance>(parts, joints, responses, std::vector<frf::Dof>{scene.force_dof.dof});
  Prepared prepared = {structure, scene.values_hz, {}};
  if (scene.values_hz.empty()) {
    for (const double hz : structure->frequency_hz()) {
      if (hz > 0.0 && (!scene.range_hz || (hz >= (*scene.range_hz)[0] && hz <= (*scene.range_hz)[1])))
        prepared.frequency_hz.push_back(hz);
    }
  }
  if (prepared.frequency_hz.empty()) {
    throw InputError({.kind = ErrorKind::data,
                      .file = scene.file.string(),
                      .place = "[frequency] range",
                      .problem = "the files have no line in it; they have " + frf::range_text(structure->frequency_hz()),
                      .remedy = "choose another range"});
  }
  prepared.doubts = passivity_doubts(*structure, structure->frequency_hz());
  return prepared;
}

double size_of(const HarmonicSolution& solution) { return std::abs(solution.response(first_row(solution), 0)); }

/// The largest point, and the peak beside it where the structure is known between frequencies.
void find_peak(const response::HarmonicBalance& balance, const ResponseScene& scene, LevelResponse& level) {
  const HarmonicSolution* best = nullptr;
  for (const HarmonicSolution& point : level.points) {
    if (point.converged && (best == nullptr || size_of(point) > size_of(*best))) best = &point;
  }
  if (best == nullptr) return;
  level.peak = *best;
  if (!scene.structure || level.points.size() < 3 || best == &level.points.front() || best == &level.points.back()) return;
  const double width = 2.0 * std::abs(best->omega - (best - 1)->omega) / best->omega;
  const int harmonic = best->harmonics[static_cast<std::size_t>(first_row(*best))];
  auto peak = response::peak_near(balance, *best, level.level, 0, harmonic, std::max(width, 1e-6));
  if (!peak || size_of(*peak) < size_of(*best)) return;
  level.peak = std::move(peak);
  level.refined = true;
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

Eigen::Index first_row(const HarmonicSolution& solution) { return solution.harmonics.front() == 0 ? 1 : 0; }

bool all_converged(const ResponseRun& run) {
  return std::ranges::all_of(run.levels, [](const LevelResponse& level) {
    return level.complete && std::ranges::all_of(level.points, &HarmonicSolution::converged);
  });
}

ResponseRun run_response(const ResponseScene& scene, Progress& progress) {
  const Prepared prepared = scene.structure ? from_matrices(scene) : from_files(scene);
  std::vector<response::Joint> joints;
  ResponseRun run;
  run.doubts = prepared.doubts;
  for (const SceneJoint& joint : scene.joints) {
    joints.push_back(joint.joint);
    run.joints.push_back(joint.joint.name);
  }
  for (const SceneDof& dof : scene.responses) run.dofs.push_back(dof.name);
  const response::HarmonicBalance balance(prepared.structure, joints, scene.force, scene.harmonics);
  std::vector<double> omegas;
  for (const double hz : prepared.frequency_hz) omegas.push_back(angular(hz));
  for (const double amplitude : scene.levels) {
    const std::string stage = fmt::format("{:.6g} N", amplitude);
    if (scene.method == CurveMethod::arc_length) {
      progress.show(stage);
      run.levels.push_back(arc_length(balance, scene, amplitude));
      find_deviations(balance, scene, run.levels.back());
      continue;
    }
    LevelResponse level = {.level = amplitude};
    level.points = response::sweep(balance, omegas, amplitude, [&](std::size_t done) {
      progress.count(stage, done, omegas.size());
      stop_if(interrupted);
    });
    find_peak(balance, scene, level);
    find_deviations(balance, scene, level);
    run.levels.push_back(std::move(level));
  }
  return run;
}

}  // namespace jointid::cli
