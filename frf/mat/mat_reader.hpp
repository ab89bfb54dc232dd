#pragma once

#include "frf/mat/mat_variable.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// The FRFs of a file of named arrays, by the conventions of mat_file.hpp. Throws InputError naming the variable.
FrfSet read_mat_frfs(MatFile& file, const OpenOptions& options);

}  // namespace jointid::frf
