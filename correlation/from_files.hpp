#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "correlation/expanded_frfs.hpp"

namespace jointid::correlation {

/// FRFs and modes (dataset 55) of a file. Throw InputError as frf::open_as_one() and frf::read_uff55().
frf::FrfSet read_frfs(const std::filesystem::path& file);
ModeFile read_modes(const std::filesystem::path& file);

/// expanded() by way "extended" or "semm", whose parent has FRFs, or "serep", whose parent has modes, of which so many are kept
/// (0: all).
ExpandedFrfs expanded_files(const std::filesystem::path& parent, const std::filesystem::path& measured, const std::string& way,
                            std::size_t modes);

}  // namespace jointid::correlation
