#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "frf/mat/mat_variable.hpp"

namespace jointid::frf {

/// Whether a file begins with the header of a variable of MATLAB v4, which has no mark of its own.
bool looks_like_mat_v4(std::string_view head);

/// Its variables: matrices of any number type, real or complex, and texts, of either byte order. Throws InputError (data) naming the
/// variable where the file is cut off, or a header is none.
std::unique_ptr<MatFile> open_mat_variables_v4(const std::filesystem::path& path);

}  // namespace jointid::frf
