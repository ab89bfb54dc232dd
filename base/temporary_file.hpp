#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.hpp"

namespace jointid {

/// Throws InputError for what is there and is no file: a pipe, which a reader waits for, a device, a socket. Folders, and names
/// of nothing, pass: who opens them says so.
void require_regular_file(const std::filesystem::path& path, ErrorKind kind = ErrorKind::data);

/// A name in the folder of `target` under which a file is written until it is complete. `commit` renames it
/// to `target`; without it the destructor removes it, so `target` is either whole or untouched.
class TemporaryFile {
 public:
  /// Creates the empty temporary. A target that is a link stands for the file behind it. Throws InputError when the folder does
  /// not take it, and for a target that is a folder, a device or a pipe.
  explicit TemporaryFile(std::filesystem::path target);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& target() const { return target_; }

  /// Throws InputError when renaming fails.
  void commit();

  /// Throws InputError saying that `target` cannot be written and why.
  [[noreturn]] void fail(const std::string& why) const;

 private:
  std::filesystem::path target_;
  std::filesystem::path path_;  ///< empty once committed
};

/// Numbers that memory should not hold, one run behind the other, in a file without a name that vanishes with the object.
class NumberSpool {
 public:
  /// `file`: whose numbers they are, for messages.
  explicit NumberSpool(std::string file) : file_(std::move(file)) {}

  /// Where they begin. The first ones make the file. Throws InputError when the disk does not take them.
  std::size_t put(std::span<const double> numbers);
  /// Those from `first` on, which were put.
  void get(std::size_t first, std::span<double> numbers);

 private:
  struct Close {
    void operator()(std::FILE* stream) const { std::fclose(stream); }
  };
  std::string file_;
  std::unique_ptr<std::FILE, Close> stream_;
  std::size_t count_ = 0;
};

/// Removes the temporaries of all files that are being written, for a signal handler that ends the process.
void remove_unfinished() noexcept;

/// Writes `text` to `target` by way of a temporary. Throws InputError when the disk does not take it.
void write_text(const std::filesystem::path& target, std::string_view text);

}  // namespace jointid
