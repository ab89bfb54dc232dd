#pragma once

#include "frf/mat/mat_module.hpp"

namespace jointid::frf::mat {

/// The functions of MatioModule, each in a source of its own.
std::unique_ptr<MatFile> open_file(const std::filesystem::path& path);
std::size_t inflate_raw(std::string_view packed, std::span<char> out);
void write_file(const FrfSet& set, const TemporaryFile& file);

}  // namespace jointid::frf::mat
