#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "frf/mat/mat_variable.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether a text begins as GNU Octave's `save -text` writes it: comments, then "# name: H", "# type: complex matrix".
bool looks_like_octave_text(std::span<const char> head);

/// Its variables: scalars, matrices and arrays, real or complex, ranges, texts, cells of texts, structs ("S.field", of arrays of
/// structs "S(2).field"). Throws InputError naming the variable where fewer numbers stand there than its sizes say.
std::unique_ptr<MatFile> open_octave_variables(const std::filesystem::path& path);

/// FRFs among them, as of MATLAB files (open_mat_v5()).
std::unique_ptr<FrfSource> open_octave_text(const std::filesystem::path& path, const OpenOptions& options = {});

}  // namespace jointid::frf
