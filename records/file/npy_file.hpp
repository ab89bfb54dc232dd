#pragma once

#include <filesystem>

#include "frf/file/columns.hpp"
#include "frf/npy/npy_header.hpp"

namespace jointid::records {

using frf::looks_like_npy;

/// Reads an array that numpy.save() wrote (formats 1.0, 2.0 and 3.0): one or two axes of real numbers (f4 f8 i1 u1 i2 u2 i4 u4 i8
/// u8, either byte order), in C or Fortran order. The longer axis counts the samples; the columns are 1, 2, … Strict: the header
/// must be the one that numpy writes (keys descr, fortran_order and shape, each once), and the file must be just as long as it
/// says. Throws InputError (data) for anything else.
frf::Columns read_npy(const std::filesystem::path& path);

}  // namespace jointid::records
