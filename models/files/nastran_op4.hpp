#pragma once

#include "models/files/file_matrix.hpp"

namespace jointid::models {

/// Whether a file is one of Nastran's OUTPUT4, by its first record.
bool is_op4(const std::filesystem::path& file);

/// A matrix of an OUTPUT4 file: text or binary of either byte order, by columns or sparse (both forms of strings, BIGMAT or not),
/// real or complex, of single or double precision. `name`: which; empty: the only one. Throws InputError (data) with line or byte
/// of what is no such file, for matrices that are not square, and for 64-bit integers.
FileMatrix read_op4(const std::filesystem::path& file, const std::string& name = {});

}  // namespace jointid::models
