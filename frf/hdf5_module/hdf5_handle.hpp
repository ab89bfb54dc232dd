#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace jointid::frf::hdf5 {

/// HDF5's hid_t, spelled out so that hdf5.h stays out of headers.
using Id = std::int64_t;

/// Owns one HDF5 identifier of any kind; a negative identifier owns nothing.
class Handle {
 public:
  Handle() = default;
  explicit Handle(Id id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() { close(); }

  Id get() const { return id_; }
  bool is_open() const { return id_ >= 0; }

  /// Gives up the identifier and returns whether HDF5 closed it cleanly (a file: was written to the end).
  bool close();

 private:
  Id id_ = -1;
};

/// Keeps HDF5 from printing its error stack on this thread while it lives.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int (*function_)(Id, void*) = nullptr;
  void* data_ = nullptr;
};

/// Keeps of the metadata of an open file, such as the places of its chunks, no more than `most_bytes` of their size in the file,
/// several times as much in memory. HDF5 lets them grow to 32 MB. For long tables, whose chunks are gone through in order.
void limit_metadata(const Handle& file, std::size_t most_bytes = std::size_t{64} << 10);

/// HDF5's own words for the last failure on this thread, innermost cause first, or empty.
std::string last_failure();

}  // namespace jointid::frf::hdf5
