#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::cli {

/// The DOFs of a list; throws InputError as frf::Dof::parse().
std::vector<frf::Dof> parse_dofs(const std::vector<std::string>& texts);

/// Options for what the user knows of an FRF file that does not say it itself.
void add_open_options(CLI::App* command, frf::OpenOptions& open);

}  // namespace jointid::cli
