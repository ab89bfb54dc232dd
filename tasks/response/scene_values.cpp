#include "tasks/response/scene_values.hpp"

#include <string>

#include "base/eigen.hpp"
#include "models/matrix_value.hpp"

namespace jointid::tasks {

Eigen::SparseMatrix<double> read_sparse_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size,
                                               std::vector<ident::NamedFile>& files) {
  if (item.is_text()) files.push_back({models::read_file_variable(item, folder).file, item.path()});
  return models::read_matrix_value(item, folder, size);
}

Eigen::MatrixXd read_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size,
                            std::vector<ident::NamedFile>& files) {
  return read_sparse_matrix(item, folder, size, files);
}

Eigen::VectorXd read_vector(const scene::Item& item) {
  const std::vector<scene::Item> list = item.list_not_empty();
  Eigen::VectorXd out(at(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i) out(at(i)) = list[i].number();
  return out;
}

}  // namespace jointid::tasks
