#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

/// What holds for file `k` of `count`: where as many responses (or references) were given as there are files, the k-th is that of file k;
/// else all are those of every file. So files of one FRF each, whose labels say nothing, get DOFs of their own.
OpenOptions options_of_file(const OpenOptions& options, std::size_t k, std::size_t count);

/// The files of one structure as one source: opened where there is one, merged in memory (merged()) where there are several. Throws
/// InputError as open() and merged().
std::unique_ptr<FrfSource> open_as_one(const std::vector<std::filesystem::path>& files, const OpenOptions& options = {});

}  // namespace jointid::frf
