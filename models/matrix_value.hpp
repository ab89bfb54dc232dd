#pragma once

#include <Eigen/SparseCore>
#include <filesystem>
#include <string>

#include "models/files/file_matrix.hpp"
#include "scene/reader.hpp"

namespace jointid::models {

/// A variable of a file as scenes name it: "model.mat:M", "m.mtx".
struct FileVariable {
  std::filesystem::path file;  ///< resolved against the folder of the scene
  std::string variable;        ///< empty where none is named
};

/// Splits at the last colon. Throws InputError (usage) for an empty text.
FileVariable read_file_variable(const scene::Item& item, const std::filesystem::path& folder);

/// A symmetric matrix inline or from a file (read_file_matrix()). Throws InputError where it is not symmetric.
FileMatrix read_labelled_value(const scene::Item& item, const std::filesystem::path& folder);

/// The same of a real one. `size`: its rows; 0: any. Throws InputError where it has another size.
Eigen::SparseMatrix<double> read_matrix_value(const scene::Item& item, const std::filesystem::path& folder, Eigen::Index size);

}  // namespace jointid::models
