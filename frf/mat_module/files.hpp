#pragma once

#include "frf/mat/mat_module.hpp"

namespace jointid::frf::mat {

/// The functions of MatioModule, each in a source of its own.
std::unique_ptr<MatFile> open_file(const std::filesystem::path& path);
void write_file(const FrfSet& set, const TemporaryFile& file);

}  // namespace jointid::frf::mat
