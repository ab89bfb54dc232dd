#include <cmath>
#include <utility>

#include "cli/response/response_sections.hpp"
#include "response/structure/matrix_file.hpp"
#include "response/structure/modal_damping.hpp"

namespace jointid::cli {
namespace {

using scene::Item;
using scene::Table;

constexpr Eigen::Index most_modes = 5000;  ///< of modal damping, which needs them all

/// Reads [structure].
class StructureReader {
 public:
  StructureReader(const scene::Item& item, const ident::Path& folder, ResponseScene& scene)
      : item_(item), folder_(folder), scene_(scene), table_(item.table({"mass", "stiffness", "damping", "modal_damping"})) {}

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
    const scene::Item item = table_.require(key);
    const Sparse found = item.is_text() ? from_file(item, key) : Sparse(inline_matrix(item).sparseView());
    if (size > 0 && found.rows() != size) {
      item.fail("the matrix has " + std::to_string(found.rows()) + " rows, the mass matrix " + std::to_string(size));
    }
    if (!symmetric(found)) item.fail("the matrix is not symmetric", "mass, damping and stiffness are");
    return found;
  }

  static bool symmetric(const Sparse& m) {
    const Sparse transposed = m.transpose();
    return (m - transposed).norm() <= 1e-9 * m.norm();
  }

  Sparse from_file(const scene::Item& item, const std::string& key) const {
    std::string name = item.text_not_empty(), variable;
    const std::size_t colon = name.rfind(':');
    if (colon != std::string::npos && colon > 0) {
      variable = name.substr(colon + 1);
      name.resize(colon);
    }
    scene_.matrix_files.push_back({folder_ / name, "[structure] " + key});
    return response::read_symmetric_sparse(folder_ / name, variable);
  }

  static Eigen::MatrixXd inline_matrix(const scene::Item& item) {
    const ident::Matrix rows = item.square_matrix(item.list_not_empty().size());
    Eigen::MatrixXd found(at(rows.size()), at(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) found(at(i), at(j)) = rows[i][j];
    }
    return found;
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

}  // namespace jointid::cli
