#include "tasks/response/prepared.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "response/condensation/condensation.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "tasks/response/modal_parts.hpp"
#include "tasks/response/part_doubts.hpp"

namespace jointid::tasks {
namespace {

constexpr int looked_ahead = 6;     ///< harmonics beyond the last one that tell what it leaves out
constexpr double neighbour = 1e-4;  ///< of ω: how far a neighbour is where the structure is known everywhere

/// The scene's values, or points over its range.
std::vector<double> asked_hz(const ResponseScene& scene) {
  std::vector<double> all = scene.values_hz;
  for (std::size_t i = 0; scene.range_hz && i < scene.points; ++i) {
    const auto [from, to] = *scene.range_hz;
    all.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(scene.points - 1));
  }
  return all;
}

/// Those frequencies and their multiples, ascending.
std::vector<double> asked_lines_hz(const ResponseScene& scene) {
  const int largest = scene.harmonics.fixed.empty() ? scene.harmonics.largest : scene.harmonics.fixed.back();
  std::vector<double> all;
  for (const double hz : asked_hz(scene)) {
    for (int n = 1; n <= largest + looked_ahead; ++n) all.push_back(n * hz);
  }
  std::ranges::sort(all);
  const auto same = [](double a, double b) { return b - a <= 1e-10 * b; };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  return all;
}

/// Columns of joints, responses and the force, N × each.
struct Columns {
  Eigen::MatrixXd joints, responses, force;
};

/// Free modes, and the deflections by joints and the force, for what marches in time.
void condense_marched(const Columns& columns, const ResponseScene& scene, Prepared& prepared) {
  const response::MatrixStructure full =
      scene.structure ? *scene.structure
                      : response::MatrixStructure{Eigen::MatrixXd(scene.sparse->mass), Eigen::MatrixXd(scene.sparse->damping),
                                                  Eigen::MatrixXd(scene.sparse->stiffness)};
  Eigen::MatrixXd loads(full.mass.rows(), columns.joints.cols() + columns.force.cols());
  loads << columns.joints, columns.force;
  const response::JointedStructure loaded = {
      full, loads, std::vector<std::shared_ptr<const friction::Element>>(static_cast<std::size_t>(loads.cols()))};
  const Eigen::MatrixXd basis = response::free_and_attachment_modes(loaded, *scene.modes).columns;
  const auto project = [&](const Eigen::MatrixXd& matrix) { return Eigen::MatrixXd(basis.transpose() * matrix * basis); };
  prepared.marched = {{project(full.mass), project(full.damping), project(full.stiffness)},
                      basis.transpose() * columns.joints,
                      joints_of(scene),
                      basis.transpose() * columns.force};
  prepared.responses = basis.transpose() * columns.responses;
  prepared.basis = basis;
}

Prepared from_matrices(const ResponseScene& scene) {
  const Eigen::Index n = coordinates(scene);
  Eigen::MatrixXd joints = Eigen::MatrixXd::Zero(n, at(scene.joints.size())), force = Eigen::MatrixXd::Zero(n, 1);
  Eigen::MatrixXd responses = Eigen::MatrixXd::Zero(n, at(scene.responses.size()));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    joints(scene.joints[j].positive.coordinate, at(j)) += 1.0;
    if (scene.joints[j].negative) joints(scene.joints[j].negative->coordinate, at(j)) -= 1.0;
  }
  for (std::size_t r = 0; r < scene.responses.size(); ++r) responses(scene.responses[r].coordinate, at(r)) = 1.0;
  if (!scene.levels.empty()) force(scene.force_dof.coordinate, 0) = 1.0;
  Prepared prepared;
  prepared.everywhere = true;
  prepared.frequency_hz = scene.values_hz;
  if (scene.sparse) {
    prepared.structure = std::make_shared<response::SparseReceptance>(*scene.sparse, joints, responses, force);
  } else {
    prepared.structure = std::make_shared<response::MatrixReceptance>(*scene.structure, joints, responses, force);
    prepared.assembly = {*scene.structure, joints, joints_of(scene), force};
  }
  prepared.responses = responses;
  prepared.marched = prepared.assembly;
  if (scene.modes) condense_marched({joints, responses, force}, scene, prepared);
  if (scene.method == CurveMethod::sweep) prepared.frequency_hz = asked_hz(scene);
  return prepared;
}

Prepared from_parts(const ResponseScene& scene, std::vector<std::unique_ptr<frf::FrfSource>> sources,
                    const ident::Control& control) {
  Prepared prepared;
  std::unique_ptr<frf::FrfSystem> parts;
  if (scene.modal_model) {
    parts = modal_parts(scene, sources, asked_lines_hz(scene), control, prepared.doubts);
  } else {
    parts = std::make_unique<frf::FrfSystem>("[data] parts", std::move(sources), frf::Composition::uncoupled, scene.reciprocity);
  }
  std::vector<response::JointEnds> joints;
  std::vector<frf::Dof> responses;
  for (const SceneJoint& joint : scene.joints) {
    joints.push_back({joint.positive.dof, joint.negative ? std::optional(joint.negative->dof) : std::nullopt});
  }
  for (const SceneDof& dof : scene.responses) responses.push_back(dof.dof);
  const auto structure =
      std::make_shared<response::FrfReceptance>(*parts, joints, responses, std::vector<frf::Dof>{scene.force_dof.dof});
  prepared.structure = structure;
  prepared.lines_hz = structure->frequency_hz();
  prepared.frequency_hz = scene.values_hz;
  if (scene.modal_model) {
    prepared.frequency_hz = asked_hz(scene);
    std::erase_if(prepared.frequency_hz, [&](double hz) { return !structure->covers(angular(hz)); });
  } else if (scene.values_hz.empty()) {
    for (const double hz : prepared.lines_hz) {
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
  for (const std::string& doubt : part_doubts(*structure, *parts)) prepared.doubts.push_back(doubt);
  return prepared;
}

}  // namespace

std::vector<response::Joint> joints_of(const ResponseScene& scene) {
  std::vector<response::Joint> joints;
  for (const SceneJoint& joint : scene.joints) joints.push_back(joint.joint);
  return joints;
}

Prepared prepare(const ResponseScene& scene, const ident::Control& control) {
  return coordinates(scene) > 0 ? from_matrices(scene) : from_parts(scene, ident::open_all(scene.parts), control);
}

Prepared prepare(const ResponseScene& scene, std::vector<frf::FrfSet> parts, const ident::Control& control) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  for (frf::FrfSet& part : parts) {
    frf::validate(part);
    sources.push_back(frf::from_memory(std::move(part)));
  }
  return from_parts(scene, std::move(sources), control);
}

Eigen::VectorXd Prepared::unit_force(Eigen::Index coordinate) const {
  if (basis.size() > 0) return basis.row(coordinate).transpose();
  return Eigen::VectorXd::Unit(responses.rows(), coordinate);
}

std::optional<std::array<double, 2>> Prepared::beside(double omega) const {
  if (everywhere) return std::array{omega * (1.0 - neighbour), omega * (1.0 + neighbour)};
  std::vector<double> known;
  for (const double hz : lines_hz) known.push_back(angular(hz));
  const auto above = std::ranges::upper_bound(known, omega * (1.0 + neighbour));
  const auto below = std::ranges::lower_bound(known, omega * (1.0 - neighbour));
  if (above == known.end() || below == known.begin() || *(below - 1) <= 0.0) return std::nullopt;
  return std::array{*(below - 1), *above};
}

}  // namespace jointid::tasks
