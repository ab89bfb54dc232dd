#include "impedance/scene/line_scene.hpp"

#include <algorithm>

#include "ident/scene/scene_failure.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::impedance {
namespace {

using restrictions::EntryMatrix;
using restrictions::JointSpec;
using restrictions::Kind;
using restrictions::Pattern;

const std::vector<std::string> structures = {"symmetric", "diagonal", "massless", "masses", "given"};

/// Facing halves in the order of the DOFs: those of the first part, then those of the second.
std::vector<std::pair<std::size_t, std::size_t>> halves_of(std::size_t size) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0; i < size / 2; ++i) out.emplace_back(i, size / 2 + i);
  return out;
}

/// T z Tᵀ as a matrix of names, and masses on its diagonal.
EntryMatrix between_halves(const LineScene& scene, std::size_t size) {
  std::vector<std::vector<std::string>> sums(size, std::vector<std::string>(size));
  const auto& facing = scene.facing;
  for (std::size_t i = 0; i < facing.size(); ++i) {
    for (std::size_t k = 0; k < facing.size(); ++k) {
      const std::string z = "z" + std::to_string(std::min(i, k) + 1) + "_" + std::to_string(std::max(i, k) + 1);
      sums[facing[i].first][facing[k].first] = sums[facing[i].second][facing[k].second] = z;
      sums[facing[i].first][facing[k].second] = sums[facing[i].second][facing[k].first] = "-" + z;
    }
  }
  if (scene.structure == Structure::masses) {
    for (std::size_t i = 0; i < size; ++i) sums[i][i] += "+m" + std::to_string(i + 1);
  }
  EntryMatrix matrix;
  for (const auto& row : sums) matrix.emplace_back(row.begin(), row.end());
  return matrix;
}

}  // namespace

bool has_halves(Structure structure) { return structure == Structure::massless || structure == Structure::masses; }

std::string name(Structure structure) { return structures[static_cast<std::size_t>(structure)]; }

const std::vector<std::string>& way_names() {
  static const std::vector<std::string> words = {"likelihood",   "weighed",  "primal",   "dual", "average",
                                                 "off-diagonal", "relative", "extended", "nj",   "nn"};
  return words;
}

std::string name(Way way) { return way_names()[static_cast<std::size_t>(way)]; }

void set_structure(LineScene& scene) {
  JointSpec& joint = scene.scene.joints.front();
  const std::size_t size = joint.dofs.size();
  if (scene.structure == Structure::symmetric && !scene.facing.empty() && 2 * scene.facing.size() != size) {
    ident::fail(scene.scene, "[joint] facing", "some DOFs of the joint face no other", "pair all of them, or remove facing");
  }
  if (has_halves(scene.structure)) {
    if (scene.facing.empty() && size % 2 == 0) scene.facing = halves_of(size);
    if (2 * scene.facing.size() != size) {
      ident::fail(scene.scene, "[joint] facing",
                  "the joint has " + std::to_string(size) + " DOFs, of which facing ones are pairs",
                  "list the DOFs of one part, then those that face them; or give facing = [[\"4:+Y\", \"5:+Y\"], …]");
    }
    joint.matrices[Kind::stiffness] = between_halves(scene, size);
  } else if (scene.structure != Structure::given) {
    joint.matrices[Kind::stiffness] = scene.structure == Structure::symmetric ? Pattern::symmetric : Pattern::diagonal;
  }
  joint.matrices[Kind::hysteretic_damping] = joint.matrices.at(Kind::stiffness);
  const restrictions::Restriction all = restrictions::build({joint});
  if (!all.symmetric()) ident::fail(scene.scene, "[joint] lines", "the matrix is not symmetric", "Z is: FRFs are reciprocal");
  for (const restrictions::MatrixTerms& matrix : all.matrices) {
    if (!matrix.known.empty()) ident::fail(scene.scene, "[joint] lines", "the matrix has known numbers", "write names or 0");
  }
  ident::IdentifySection& identify = scene.scene.identify;
  identify.method = ident::Method::likelihood;
  identify.automatic = false;
  identify.start[Kind::stiffness] = ident::Matrix(size, std::vector<double>(size, 0.0));
}

}  // namespace jointid::impedance
