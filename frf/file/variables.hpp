#pragma once

#include <filesystem>
#include <memory>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// The named arrays of a MATLAB, HDF5 or numpy file (.npz; the array of an .npy has the name of the file); null where it is text.
/// A sparse matrix K is the arrays K.data, K.ir (rows from 0) and K.jc (the first element of each column, and the end of the last);
/// in a file of MATLAB v4 K.data, K.row and K.col (from 0). K.shape, where there is one: the numbers of rows and columns. Throws
/// InputError (data) where the file cannot be read or is damaged.
std::unique_ptr<MatFile> open_variables(const std::filesystem::path& path);

}  // namespace jointid::frf
