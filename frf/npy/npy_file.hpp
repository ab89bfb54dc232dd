#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "frf/mat/mat_variable.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Whether a file begins as a zip archive whose first file is an array of numpy, as numpy.savez() writes it.
bool looks_like_npz(std::string_view first_bytes);

/// Opens an archive of numpy and loads its FRFs whole; its arrays are read by the conventions of mat_file.hpp: complex `frf`,
/// OpenOptions::variable or the only complex array that fits, [F], [F,R,C] or [R,C,F]; `frequency` …; texts `response_dof` and
/// `reference_dof` or `dofs`. Throws InputError naming the array.
std::unique_ptr<FrfSource> open_npz(const std::filesystem::path& path, const OpenOptions& options = {});

/// The same of one array; the frequencies are that of the file OpenOptions::frequency_variable, which stands beside it or where a
/// relative path leads to.
std::unique_ptr<FrfSource> open_npy(const std::filesystem::path& path, const OpenOptions& options = {});

/// The arrays of an archive.
std::unique_ptr<MatFile> open_npz_variables(const std::filesystem::path& path);

/// One array, which has the name of the file.
std::unique_ptr<MatFile> open_npy_variable(const std::filesystem::path& path);

}  // namespace jointid::frf
