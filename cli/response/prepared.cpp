#include "cli/response/prepared.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "dense/eigen.hpp"
#include "frf/set/frf_system.hpp"
#include "ident/plan/data_source.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"

namespace jointid::cli {
namespace {

constexpr double active = 0.02;         ///< share of |G| by which −Im G may be negative before it is told
constexpr double between_lines = 1e-4;  ///< of ω: a neighbour where the structure is known everywhere

Prepared from_matrices(const ResponseScene& scene) {
  const Eigen::Index n = scene.structure->mass.rows();
  Eigen::MatrixXd joints = Eigen::MatrixXd::Zero(n, at(scene.joints.size())), force = Eigen::MatrixXd::Zero(n, 1);
  Eigen::MatrixXd responses = Eigen::MatrixXd::Zero(n, at(scene.responses.size()));
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    joints(scene.joints[j].positive.coordinate, at(j)) += 1.0;
    if (scene.joints[j].negative) joints(scene.joints[j].negative->coordinate, at(j)) -= 1.0;
  }
  for (std::size_t r = 0; r < scene.responses.size(); ++r) responses(scene.responses[r].coordinate, at(r)) = 1.0;
  if (!scene.levels.empty()) force(scene.force_dof.coordinate, 0) = 1.0;
  Prepared prepared;
  prepared.structure = std::make_shared<response::MatrixReceptance>(*scene.structure, joints, responses, force);
  prepared.frequency_hz = scene.values_hz;
  prepared.assembly = {*scene.structure, joints, joints_of(scene), force};
  prepared.responses = responses;
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
  Prepared prepared;
  prepared.structure = structure;
  prepared.frequency_hz = scene.values_hz;
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
  prepared.lines_hz = structure->frequency_hz();
  prepared.doubts = passivity_doubts(*structure, structure->frequency_hz());
  return prepared;
}

}  // namespace

std::vector<response::Joint> joints_of(const ResponseScene& scene) {
  std::vector<response::Joint> joints;
  for (const SceneJoint& joint : scene.joints) joints.push_back(joint.joint);
  return joints;
}

Prepared prepare(const ResponseScene& scene) { return scene.structure ? from_matrices(scene) : from_files(scene); }

std::optional<std::array<double, 2>> Prepared::beside(double omega) const {
  if (assembly) return std::array{omega * (1.0 - between_lines), omega * (1.0 + between_lines)};
  std::vector<double> known;
  for (const double hz : lines_hz) known.push_back(angular(hz));
  const auto above = std::ranges::upper_bound(known, omega * (1.0 + 1e-9));
  const auto below = std::ranges::lower_bound(known, omega * (1.0 - 1e-9));
  if (above == known.end() || below == known.begin() || *(below - 1) <= 0.0) return std::nullopt;
  return std::array{*(below - 1), *above};
}

}  // namespace jointid::cli
