#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <string>

#include "base/error.hpp"

namespace jointid::frf::mat {

/// What is wrong with the bytes of a MATLAB file; whoever knows the file makes an InputError of it.
class Damaged : public InputError {
 public:
  explicit Damaged(const std::string& problem)
      : InputError({.kind = ErrorKind::data, .file = "", .place = "", .problem = problem, .remedy = ""}) {}
};

/// Bytes one after the other, never many at a time.
class Bytes {
 public:
  virtual ~Bytes() = default;
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  /// Fills `out`. Throws Damaged when there are fewer.
  virtual void read(std::span<unsigned char> out) = 0;
  virtual void skip(std::uint64_t count);
  /// Throws Damaged unless all has been read and, for deflate, the checksum agrees.
  virtual void finish() {}

 protected:
  Bytes() = default;
};

/// `size` bytes of a file from `begin` on, as they stand there or inflated.
std::unique_ptr<Bytes> stored_bytes(std::ifstream& file, std::uint64_t begin, std::uint64_t size);
std::unique_ptr<Bytes> inflated_bytes(std::ifstream& file, std::uint64_t begin, std::uint64_t size);

}  // namespace jointid::frf::mat
