#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace jointid::frf {

enum class FileFormat : std::uint8_t { jointid_hdf5, uff, matlab_v5, matlab_v73, csv, analyser_text };

/// "HDF5 jointid-frf", "UFF", "MATLAB v5 to v7", "MATLAB v7.3", "CSV", "analyser text".
std::string name(FileFormat format);

/// Recognises a file by its first bytes. Throws InputError naming what was found when it is none of them.
FileFormat detect_format(const std::filesystem::path& path);

/// The same of files that are not text, HDF5 or MATLAB; nothing for any other that can be read.
std::optional<FileFormat> detect_binary_format(const std::filesystem::path& path);

}  // namespace jointid::frf
