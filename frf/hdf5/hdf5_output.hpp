#pragma once

#include <filesystem>

#include "base/temporary_file.hpp"
#include "frf/hdf5/hdf5_handle.hpp"

namespace jointid::frf::hdf5 {

/// An HDF5 file that appears under its name once it is complete. Whoever writes to it passes every outcome to require().
class Output {
 public:
  /// Throws InputError when the folder does not take the file.
  explicit Output(const std::filesystem::path& path);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  const Handle& file() const { return file_; }

  /// Throws InputError with the disk's reason when it has refused something, else with HDF5's when `ok` is false.
  void require(bool ok) const;

  /// Throws InputError saying that the file cannot be written and why.
  [[noreturn]] void fail(const std::string& why) const { temporary_.fail(why); }

  /// Closes the file, whose datasets were closed with the outcome `closed`, and gives it its name. Throws InputError.
  void finish(bool closed);

 private:
  TemporaryFile temporary_;
  int disk_error_ = 0;  ///< before the file, which reports to it until closed
  Handle file_;
};

}  // namespace jointid::frf::hdf5
