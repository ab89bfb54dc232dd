#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frf/set/frf_source.hpp"

namespace jointid::frf {

enum class FileFormat : std::uint8_t { jointid_hdf5, uff, matlab_v5, matlab_v73, csv, analyser_text, npz, npy, octave_text };

/// A format of files that hold FRFs.
struct Format {
  FileFormat format;
  std::string name;
  bool binary = false;
  bool variables = false;     ///< OpenOptions::variable and frequency_variable apply
  bool takes_unit = false;    ///< OpenOptions::unit applies: files state no unit, or their labels are often wrong
  bool states_hertz = false;  ///< OpenOptions::frequency_unit does not apply: the frequencies are in Hz
  bool (*is_of)(const std::filesystem::path& path, std::string_view head);  ///< by the first bytes of a file
  std::unique_ptr<FrfSource> (*open)(const std::filesystem::path& path, const OpenOptions& options);
  std::vector<std::string> extensions{};  ///< of files that write() writes in it
  void (*write)(const FrfSet& set, const std::filesystem::path& path) = nullptr;
};

/// All of them, in the order in which files are tried.
const std::vector<Format>& formats();

/// The format of a file by its first bytes. Throws InputError naming what was found when it is none of them.
const Format& format_of(const std::filesystem::path& path);

/// "HDF5 jointid-frf", "UFF", "MATLAB v4 to v7", "MATLAB v7.3", "numpy npz", "numpy npy", "CSV", "analyser text", "Octave text".
std::string name(FileFormat format);

/// As format_of().
FileFormat detect_format(const std::filesystem::path& path);

/// The same of HDF5 and MATLAB; nothing for any other file that can be read.
std::optional<FileFormat> detect_binary_format(const std::filesystem::path& path);

/// The same of HDF5, MATLAB and numpy.
std::optional<FileFormat> detect_array_format(const std::filesystem::path& path);

}  // namespace jointid::frf
