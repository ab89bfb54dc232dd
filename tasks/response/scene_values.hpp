#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "ident/scene/scene_files.hpp"
#include "scene/reader.hpp"

namespace jointid::tasks {

/// A symmetric matrix inline, or from a file "m.mtx", "model.mat:M" beside the scene, which is added to `files`. `size`: its
/// rows; 0: any.
Eigen::SparseMatrix<double> read_sparse_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size,
                                               std::vector<ident::NamedFile>& files);
Eigen::MatrixXd read_matrix(const scene::Item& item, const ident::Path& folder, Eigen::Index size,
                            std::vector<ident::NamedFile>& files);

/// A list of numbers, at least one.
Eigen::VectorXd read_vector(const scene::Item& item);

}  // namespace jointid::tasks
