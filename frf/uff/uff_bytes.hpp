#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace jointid::frf::uff {

/// Where in a file something was found, for messages.
struct Place {
  std::string file;
  std::string dataset;     ///< e.g. "dataset 58 number 3"
  std::uint64_t byte = 0;  ///< offset of the dataset's number line

  /// Throws InputError (data) at "<dataset>, <detail> (byte N)".
  [[noreturn]] void fail(const std::string& detail, const std::string& problem,
                         const std::string& remedy) const;
};

/// A file read in part: lines from a position on, or a number of bytes from an offset.
class ByteFile {
 public:
  explicit ByteFile(const std::filesystem::path& path);
  ~ByteFile();
  ByteFile(const ByteFile&) = delete;
  ByteFile& operator=(const ByteFile&) = delete;

  const std::string& name() const { return name_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);

  /// The line at the position, without its end (LF or CR LF); it stands until the next call. False at the end
  /// of the file.
  bool next_line(std::string_view& line);

  /// `count` bytes from `offset` on; the caller has compared them with size().
  std::string read(std::uint64_t offset, std::uint64_t count);

 private:
  std::string name_;
  std::ifstream stream_;  ///< for lines
  int exact_ = -1;        ///< for numbers: a few bytes cost a few bytes, not a buffer of them
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::string line_;
};

}  // namespace jointid::frf::uff
