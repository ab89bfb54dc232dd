#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// Options for file `k` of `count`. If there are as many responses (or references) as files, the k-th is that of file k; else all
/// are those of every file. So files of one FRF each with useless labels get separate DOFs.
OpenOptions options_of_file(const OpenOptions& options, std::size_t k, std::size_t count);

/// The files of one structure as one source: opened if there is one, merged in memory (merged()) if there are several. Throws
/// InputError as open() and merged().
std::unique_ptr<FrfSource> open_as_one(const std::vector<std::filesystem::path>& files, const OpenOptions& options = {});

}  // namespace jointid::frf
