#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace jointid {

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

/// Removes the temporaries of all files that are being written, for a signal handler that ends the process.
void remove_unfinished() noexcept;

/// Writes `text` to `target` by way of a temporary. Throws InputError when the disk does not take it.
void write_text(const std::filesystem::path& target, std::string_view text);

}  // namespace jointid
