#include "models/matrix_value.hpp"

#include "base/eigen.hpp"
#include "models/files/matrix_file.hpp"

namespace jointid::models {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

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

FileMatrix read_labelled_value(const scene::Item& item, const std::filesystem::path& folder) {
  if (item.is_text()) {
    const FileVariable named = read_file_variable(item, folder);
    return read_file_matrix(named.file, named.variable);
  }
  FileMatrix found{Sparse(inline_matrix(item).sparseView()), {}, {}};
  const Sparse transposed = found.real.transpose();
  if ((found.real - transposed).norm() > 1e-9 * found.real.norm())
    item.fail("the matrix is not symmetric", "mass, damping and stiffness are");
  return found;
}

Sparse read_matrix_value(const scene::Item& item, const std::filesystem::path& folder, Eigen::Index size) {
  const FileMatrix found = read_labelled_value(item, folder);
  if (found.imaginary.nonZeros() > 0) item.fail("the matrix is complex", "only the stiffness of a model may be");
  if (size > 0 && found.real.rows() != size) {
    item.fail("the matrix has " + std::to_string(found.real.rows()) + " rows, the mass matrix " + std::to_string(size));
  }
  return found.real;
}

}  // namespace jointid::models
