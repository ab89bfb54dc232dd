#include <utility>

#include "cli/options/scene_values.hpp"
#include "cli/response/response_sections.hpp"
#include "response/structure/modal_damping.hpp"

namespace jointid::cli {
namespace {

using ident::SceneItem;
using ident::SceneTable;

/// Reads [structure].
class StructureReader {
 public:
  StructureReader(const SceneItem& item, const ident::Path& folder, ResponseScene& scene)
      : item_(item), folder_(folder), scene_(scene), table_(item.table({"mass", "stiffness", "damping", "modal_damping"})) {}

  void read() {
    response::MatrixStructure structure;
    structure.mass = matrix(table_.require("mass"), 0);
    const Eigen::Index n = structure.mass.rows();
    structure.stiffness = matrix(table_.require("stiffness"), n);
    structure.damping = Eigen::MatrixXd::Zero(n, n);
    const auto damping = table_.find("damping"), modal = table_.find("modal_damping");
    if (damping && modal) item_.fail("there are both damping and modal_damping", "remove one");
    if (damping) structure.damping = matrix(*damping, n);
    if (modal) structure.damping = response::modal_damping(structure.mass, structure.stiffness, modal->not_negative());
    scene_.structure = std::move(structure);
  }

 private:
  Eigen::MatrixXd matrix(const SceneItem& item, Eigen::Index size) const {
    return read_matrix(item, folder_, size, scene_.matrix_files);
  }

  const SceneItem& item_;
  ident::Path folder_;
  ResponseScene& scene_;
  SceneTable table_;
};

}  // namespace

void read_structure(const SceneItem& item, const ident::Path& folder, ResponseScene& scene) {
  StructureReader(item, folder, scene).read();
}

}  // namespace jointid::cli
