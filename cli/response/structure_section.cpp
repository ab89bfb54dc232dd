#include <cmath>
#include <utility>

#include "cli/response/response_sections.hpp"
#include "response/structure/matrix_file.hpp"
#include "response/structure/modal_damping.hpp"

namespace jointid::cli {
namespace {

using scene::Item;
using scene::Table;

/// Reads [structure].
class StructureReader {
 public:
  StructureReader(const scene::Item& item, const ident::Path& folder, ResponseScene& scene)
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
  Eigen::MatrixXd matrix(const scene::Item& item, Eigen::Index size) const {
    const Eigen::MatrixXd found = item.is_text() ? from_file(item) : inline_matrix(item);
    if (size > 0 && found.rows() != size) {
      item.fail("the matrix has " + std::to_string(found.rows()) + " rows, the mass matrix " + std::to_string(size));
    }
    if (!found.isApprox(found.transpose(), 1e-9)) item.fail("the matrix is not symmetric", "mass, damping and stiffness are");
    return found;
  }

  Eigen::MatrixXd from_file(const scene::Item& item) const {
    std::string name = item.text_not_empty(), variable;
    const std::size_t colon = name.rfind(':');
    if (colon != std::string::npos && colon > 0) {
      variable = name.substr(colon + 1);
      name.resize(colon);
    }
    scene_.matrix_files.push_back({folder_ / name, item.place()});
    return response::read_symmetric_matrix(folder_ / name, variable);
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
