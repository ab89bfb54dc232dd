#pragma once

#include <string>

#include "frf/mat/mat_variable.hpp"
#include "models/files/file_matrix.hpp"

namespace jointid::models {

/// A matrix among the arrays of a file: real or complex numbers [n, n], or the arrays of a sparse matrix, which are
///   - data, ir, jc: compressed columns of MATLAB (rows and begins of columns from 0);
///   - data, indices, indptr: compressed columns or rows of scipy;
///   - data, row, col: elements by their places, from 0, those of one place added.
/// They have the name of the matrix and a dot before their own, none in what scipy.sparse.save_npz() writes. `variable` names the matrix;
/// empty: the only one. Throws InputError (data) where there is none, several, or one that is not square, not finite, or damaged.
FileMatrix read_variable_matrix(frf::MatFile& file, const std::string& variable);

}  // namespace jointid::models
