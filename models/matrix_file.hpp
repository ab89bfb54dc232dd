#pragma once

#include <Eigen/SparseCore>
#include <filesystem>
#include <string>

namespace jointid::models {

/// A real symmetric matrix from a file: Matrix Market (`.mtx`: coordinate or array, real or integer, general or symmetric; what
/// is not listed is 0), or what frf::read_columns reads: MATLAB and HDF5 (`variable` names the matrix where there are several),
/// or text, a row a line. Throws InputError (data) that names line or element of what is no such matrix.
Eigen::SparseMatrix<double> read_symmetric_sparse(const std::filesystem::path& path, const std::string& variable = {});

/// The same as a full matrix of at most 20,000 rows.
Eigen::MatrixXd read_symmetric_matrix(const std::filesystem::path& path, const std::string& variable = {});

}  // namespace jointid::models
