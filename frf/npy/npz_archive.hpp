#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// A file in a zip archive.
struct NpzEntry {
  std::string name;
  bool deflated = false;
  std::uint32_t checksum = 0;  ///< CRC-32 of its bytes
  std::uint64_t size = 0;      ///< of its bytes
  std::string_view stored;     ///< as they stand in the archive
};

/// The files of a zip archive in memory, as numpy.savez() and savez_compressed() write it: stored or deflated, sizes of 32 or 64
/// bits. Throws InputError (data) naming `file` where the archive is cut off, split, encrypted or packed in another way, where
/// sizes go beyond it, and where one declares more than can be packed.
std::vector<NpzEntry> npz_entries(std::string_view archive, const std::string& file);

/// The first bytes of an entry, `most` at most; deflated ones need the module matio, which has zlib.
std::string npz_bytes(const NpzEntry& entry, std::uint64_t most, const std::string& file);

/// All of them. Throws InputError (data) where they are not as many as declared or their checksum is another.
std::string npz_bytes(const NpzEntry& entry, const std::string& file);

}  // namespace jointid::frf
