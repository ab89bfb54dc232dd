#include "frf/hdf5_module/hdf5_line_map.hpp"

#include <fcntl.h>
#include <hdf5.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.hpp"

namespace jointid::frf::hdf5 {
namespace {

/// Looking up one chunk costs HDF5 1.10 time proportional to their number; beyond this many its own reading
/// is faster.
constexpr std::size_t most_chunks = 8192;

/// Descriptor of the open file, or -1 when the file does not lie in one piece from address 0 on.
int descriptor(const Object& file) {
  const Handle plist(H5Fget_create_plist(file.id.get()));
  hsize_t user_block = 0;
  void* descriptor = nullptr;
  if (H5Pget_userblock(plist.get(), &user_block) < 0 || user_block != 0 ||
      H5Fget_vfd_handle(file.id.get(), H5P_DEFAULT, &descriptor) < 0) {
    return -1;
  }
  return *static_cast<int*>(descriptor);
}

/// Lines per chunk; all lines when contiguous; 0 when lines are cut or laid out otherwise.
std::size_t lines_per_chunk(const Dataset& dataset) {
  const Handle plist(H5Dget_create_plist(dataset.id.get()));
  const H5D_layout_t layout = H5Pget_layout(plist.get());
  if (layout == H5D_CONTIGUOUS) return dataset.dims[0];
  std::array<hsize_t, 3> chunk{};
  if (layout != H5D_CHUNKED || H5Pget_chunk(plist.get(), 3, chunk.data()) != 3) return 0;
  return chunk[1] == dataset.dims[1] && chunk[2] == dataset.dims[2] ? chunk[0] : 0;
}

}  // namespace

std::optional<LineMap> LineMap::of(const Object& file, const Dataset& dataset, const Handle& memory_type) {
  const Handle type(H5Dget_type(dataset.id.get()));
  LineMap map;
  map.lines_per_chunk_ = lines_per_chunk(dataset);
  if (map.lines_per_chunk_ == 0 || is_filtered(dataset) || H5Tequal(type.get(), memory_type.get()) <= 0)
    return {};
  const std::size_t chunks = (dataset.dims[0] - 1) / map.lines_per_chunk_ + 1;
  map.descriptor_ = descriptor(file);
  if (chunks > most_chunks || map.descriptor_ < 0) return {};
  map.line_bytes_ = dataset.dims[1] * dataset.dims[2] * H5Tget_size(type.get());
  map.addresses_.assign(chunks, 0);
  return map;
}

LineMap::Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

namespace {

/// The same file opened anew, with a shared lock of its own, or -1.
int opened_again(int descriptor) {
  const int own = ::open(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), O_RDONLY | O_CLOEXEC);
  if (own >= 0 && ::flock(own, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(own);
    return -1;
  }
  return own;
}

}  // namespace

bool LineMap::stand_alone(const Dataset& dataset) {
  constexpr std::size_t most = 64;  // chunks: their look-up takes less than the file took to open
  if (addresses_.size() > most) return false;
  try {
    for (std::size_t chunk = 0; chunk < addresses_.size(); ++chunk) chunk_address(dataset, chunk);
  } catch (const InputError&) {
    return false;  // told when that line is read
  }
  Descriptor own(opened_again(descriptor_));
  if (own.number() < 0) return false;
  descriptor_ = own.number();
  own_ = std::move(own);
  return true;
}

std::uint64_t LineMap::chunk_address(const Dataset& dataset, std::size_t chunk) {
  if (addresses_[chunk] != 0) return addresses_[chunk];
  haddr_t address = H5Dget_offset(dataset.id.get());  // defined for contiguous storage only
  if (address == HADDR_UNDEF) {
    const std::array<hsize_t, 3> corner = {chunk * lines_per_chunk_, 0, 0};
    hsize_t stored = 0;
    unsigned mask = 0;
    const herr_t found =
        H5Dget_chunk_info_by_coord(dataset.id.get(), corner.data(), &mask, &address, &stored);
    if (found < 0 || address == HADDR_UNDEF || stored < lines_per_chunk_ * line_bytes_) {
      fail(dataset, "line " + std::to_string(corner[0] + 1) + " was never written",
           "complete or shorten the file");
    }
  }
  return addresses_[chunk] = address;
}

void LineMap::read(const Dataset& dataset, std::size_t line, std::size_t from, std::span<std::byte> out) {
  std::uint64_t at =
      chunk_address(dataset, line / lines_per_chunk_) + (line % lines_per_chunk_) * line_bytes_ + from;
  while (!out.empty()) {
    const ssize_t got = ::pread(descriptor_, out.data(), out.size(), static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      fail(dataset, "line " + std::to_string(line + 1) +
                        " cannot be read: " + (got < 0 ? std::strerror(errno) : "the file ends before it"));
    }
    out = out.subspan(static_cast<std::size_t>(got));
    at += static_cast<std::uint64_t>(got);
  }
}

}  // namespace jointid::frf::hdf5
