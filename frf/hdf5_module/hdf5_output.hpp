#pragma once

#include <string>

#include "base/temporary_file.hpp"
#include "frf/hdf5_module/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// An HDF5 file where a temporary one stands, which must outlive it. Whoever writes to it passes every outcome to require().
class Output {
 public:
  /// Throws InputError when the folder does not take the file.
  explicit Output(const TemporaryFile& file);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  const Handle& file() const { return file_; }

  /// Throws InputError with the disk's reason when it has refused something, else with HDF5's when `ok` is false.
  void require(bool ok) const;

  /// Throws InputError saying that the file cannot be written and why.
  [[noreturn]] void fail(const std::string& why) const { temporary_.fail(why); }

  /// Closes the file, whose datasets were closed with the outcome `closed`. Throws InputError.
  void finish(bool closed);

 private:
  const TemporaryFile& temporary_;
  int disk_error_ = 0;  ///< before the file, which reports to it until closed
  Handle file_;
};

}  // namespace jointid::frf::hdf5
