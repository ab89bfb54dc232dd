#pragma once

#include <vector>

#include "base/eigen.hpp"
#include "ident/scene/scene_files.hpp"
#include "ident/scene/scene_reader.hpp"

namespace jointid::cli {

/// A whole number between two others.
double read_whole(const ident::SceneItem& item, double least, double most);

/// A symmetric matrix inline, or from a file "m.mtx", "model.mat:M" beside the scene, which is added to `files`. `size`: its
/// rows; 0: any.
Eigen::MatrixXd read_matrix(const ident::SceneItem& item, const ident::Path& folder, Eigen::Index size,
                            std::vector<ident::NamedFile>& files);

/// A list of numbers, at least one.
Eigen::VectorXd read_vector(const ident::SceneItem& item);

}  // namespace jointid::cli
