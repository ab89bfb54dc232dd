#pragma once

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

/// HDF5's own words for the last failure on this thread, innermost cause first, or empty.
std::string last_failure();

}  // namespace jointid::frf::hdf5
