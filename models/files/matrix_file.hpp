#pragma once

#include "models/files/file_matrix.hpp"

namespace jointid::models {

/// A symmetric matrix from a file, by its content:
///   - Matrix Market: coordinate or array; real, integer, complex or pattern (every element 1); general, symmetric, skew-symmetric or
///     hermitian, of which the symmetric ones pass; what is not listed is 0;
///   - Nastran's OUTPUT4 (read_op4()) and punched DMIG (read_dmig()), matrices of Abaqus (read_abaqus_matrix());
///   - full and sparse matrices of MATLAB, HDF5 and numpy (read_variable_matrix());
///   - rows of numbers, a row a line.
/// `variable` names the matrix where a file has several. Throws InputError (data) that names line or element of what is no such matrix.
FileMatrix read_file_matrix(const std::filesystem::path& path, const std::string& variable = {});

/// The same of real ones, without labels.
Eigen::SparseMatrix<double> read_symmetric_sparse(const std::filesystem::path& path, const std::string& variable = {});

/// The same as a full matrix of at most 20,000 rows.
Eigen::MatrixXd read_symmetric_matrix(const std::filesystem::path& path, const std::string& variable = {});

}  // namespace jointid::models
