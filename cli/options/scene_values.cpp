#include "cli/options/scene_values.hpp"

#include <string>

#include "base/eigen.hpp"
#include "response/structure/matrix_file.hpp"

namespace jointid::cli {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

Sparse matrix_from_file(const scene::Item& item, const ident::Path& folder, std::vector<ident::NamedFile>& files) {
  std::string name = item.text_not_empty(), variable;
  const std::size_t colon = name.rfind(':');
  if (colon != std::string::npos && colon > 0) {
    variable = name.substr(colon + 1);
    name.resize(colon);
  }
  files.push_back({folder / name, item.path()});
  return response::read_symmetric_sparse(folder / name, variable);
}

Eigen::MatrixXd inline_matrix(const scene::Item& item) {
  const ident::Matrix rows = item.square_matrix(item.list_not_empty().size());
  Eigen::MatrixXd found(at(rows.size()), at(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) found(at(i), at(j)) = rows[i][j];
  }
  return found;
}

}  // namespace

Sparse read_sparse_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size, std::vector<ident::NamedFile>& files) {
  const Sparse found = item.is_text() ? matrix_from_file(item, folder, files) : Sparse(inline_matrix(item).sparseView());
  if (size > 0 && found.rows() != size) {
    item.fail("the matrix has " + std::to_string(found.rows()) + " rows, the mass matrix " + std::to_string(size));
  }
  const Sparse transposed = found.transpose();
  if ((found - transposed).norm() > 1e-9 * found.norm()) item.fail("the matrix is not symmetric", "mass, damping and stiffness are");
  return found;
}

Eigen::MatrixXd read_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size, std::vector<ident::NamedFile>& files) {
  return read_sparse_matrix(item, folder, size, files);
}

Eigen::VectorXd read_vector(const scene::Item& item) {
  const std::vector<scene::Item> list = item.list_not_empty();
  Eigen::VectorXd out(at(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) out(at(i)) = list[i].number();
  return out;
}

}  // namespace jointid::cli
