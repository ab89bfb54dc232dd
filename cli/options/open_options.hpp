#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::cli {

/// The DOFs of a list; throws InputError as frf::Dof::parse().
std::vector<frf::Dof> parse_dofs(const std::vector<std::string>& texts);

/// What holds for file `k` of `count`: where as many responses (or references) were given as there are files, the k-th is that of file k;
/// else all are those of every file. So files of one FRF each, whose labels say nothing, get DOFs of their own.
frf::OpenOptions options_of_file(const frf::OpenOptions& options, std::size_t k, std::size_t count);

/// The files of one structure as one source: opened where there is one, merged in memory (frf::merged) where there are several.
std::unique_ptr<frf::FrfSource> open_as_one(const std::vector<std::filesystem::path>& files, const frf::OpenOptions& options);

/// Options for what the user knows of an FRF file that does not say it itself.
void add_open_options(CLI::App* command, frf::OpenOptions& open);

}  // namespace jointid::cli
