#include "models/matrix_value.hpp"

#include "base/eigen.hpp"
#include "models/matrix_file.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

Sparse matrix_from_file(const scene::Item& item, const std::filesystem::path& folder) {
  const FileVariable named = read_file_variable(item, folder);
  return read_symmetric_sparse(named.file, named.variable);
}

Eigen::MatrixXd inline_matrix(const scene::Item& item) {
  const scene::Matrix rows = item.square_matrix(item.list_not_empty().size());
  Eigen::MatrixXd found(at(rows.size()), at(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) found(at(i), at(j)) = rows[i][j];
  }
  return found;
}

}  // namespace

FileVariable read_file_variable(const scene::Item& item, const std::filesystem::path& folder) {
  std::string name = item.text_not_empty(), variable;
  const std::size_t colon = name.rfind(':');
  if (colon != std::string::npos && colon > 0) {
    variable = name.substr(colon + 1);
    name.resize(colon);
  }
  return {folder / name, variable};
}

Sparse read_matrix_value(const scene::Item& item, const std::filesystem::path& folder, Eigen::Index size) {
  const Sparse found = item.is_text() ? matrix_from_file(item, folder) : Sparse(inline_matrix(item).sparseView());
  if (size > 0 && found.rows() != size) {
    item.fail("the matrix has " + std::to_string(found.rows()) + " rows, the mass matrix " + std::to_string(size));
  }
  const Sparse transposed = found.transpose();
  if ((found - transposed).norm() > 1e-9 * found.norm())
    item.fail("the matrix is not symmetric", "mass, damping and stiffness are");
  return found;
}

}  // namespace jointid::models
