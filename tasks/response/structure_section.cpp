#include <algorithm>
#include <utility>

#include "response/structure/modal_damping.hpp"
#include "tasks/response/response_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {
namespace {

constexpr Eigen::Index most_modes = 5000;  ///< whose modes are computed: all of them, of full matrices

/// Reads [structure].
class StructureReader {
 public:
  StructureReader(const scene::Item& item, const ident::Path& folder, ResponseScene& scene)
      : item_(item),
        folder_(folder),
        scene_(scene),
        table_(item.table({"mass", "stiffness", "damping", "modal_damping", "modes"})) {}

  void read() {
    response::SparseStructure structure;
    structure.mass = matrix("mass", 0);
    const Eigen::Index n = structure.mass.rows();
    structure.stiffness = matrix("stiffness", n);
    structure.damping = Sparse(n, n);
    const auto damping = table_.find("damping"), modal = table_.find("modal_damping");
    if (damping && modal) item_.fail("there are both damping and modal_damping", "remove one");
    if (damping) structure.damping = matrix("damping", n);
    if (modal) require_modal(*modal, n);
    if (const auto modes = table_.find("modes")) {
      require_modal(*modes, n);
      scene_.modes = modes->whole(1, static_cast<int>(std::min(n, most_full)));
    }
    if (n > most_full && !modal) {
      scene_.sparse = std::move(structure);
      return;
    }
    scene_.structure = {Eigen::MatrixXd(structure.mass), Eigen::MatrixXd(structure.damping),
                        Eigen::MatrixXd(structure.stiffness)};
    response::MatrixStructure& full = *scene_.structure;
    if (modal) full.damping = response::modal_damping(full.mass, full.stiffness, modal->not_negative());
  }

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  static void require_modal(const scene::Item& item, Eigen::Index n) {
    if (n <= most_modes) return;
    item.fail("all modes of " + std::to_string(n) + " coordinates would be needed", "give a damping matrix");
  }

  Sparse matrix(const std::string& key, Eigen::Index size) const {
    return read_sparse_matrix(table_.require(key), folder_, size, scene_.matrix_files);
  }

  const scene::Item& item_;
  ident::Path folder_;
  ResponseScene& scene_;
  scene::Table table_;
};

}  // namespace

void read_structure(const scene::Item& item, const ident::Path& folder, ResponseScene& scene) {
  StructureReader(item, folder, scene).read();
}

}  // namespace jointid::tasks
