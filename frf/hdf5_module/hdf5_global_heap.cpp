#include "frf/hdf5_module/hdf5_global_heap.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <vector>

namespace jointid::frf::hdf5 {
namespace {

constexpr unsigned char signature[8] = {'G', 'C', 'O', 'L', 1, 0, 0, 0};  ///< version 1, reserved
constexpr std::uint64_t header_bytes = 16;                                ///< of a collection, and of an object

/// Little-endian, as all of HDF5's metadata.
std::uint64_t number(const unsigned char* bytes, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | bytes[i];
  return value;
}

bool read_at(int descriptor, std::uint64_t address, std::vector<unsigned char>& bytes) {
  return ::pread(descriptor, bytes.data(), bytes.size(), static_cast<off_t>(address)) == static_cast<ssize_t>(bytes.size());
}

/// Bytes that an object takes: its header and its contents in steps of eight; of free space (index 0) the size counts the header.
std::uint64_t extent(const unsigned char* object) {
  const std::uint64_t size = number(object + 8, 8);
  if (number(object, 2) == 0) return size;
  return size > UINT64_MAX / 2 ? size : header_bytes + (size + 7) / 8 * 8;
}

}  // namespace

bool begins_global_heap(const void* bytes, std::size_t count) {
  return count >= header_bytes && std::memcmp(bytes, signature, sizeof signature) == 0;
}

bool is_sound_global_heap(int descriptor, std::uint64_t address) {
  struct stat file {};
  std::vector<unsigned char> bytes(header_bytes);
  if (::fstat(descriptor, &file) != 0 || !read_at(descriptor, address, bytes)) return false;
  const std::uint64_t size = number(bytes.data() + 8, 8), end = static_cast<std::uint64_t>(file.st_size);
  if (size < header_bytes || address > end || size > end - address) return false;
  bytes.resize(size);
  if (!read_at(descriptor, address, bytes)) return false;
  for (std::uint64_t at = header_bytes; size - at >= header_bytes;) {
    const std::uint64_t taken = extent(bytes.data() + at);
    if (taken < header_bytes || taken > size - at) return false;
    at += taken;
  }
  return true;
}

}  // namespace jointid::frf::hdf5
