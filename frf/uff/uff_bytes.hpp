#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A file read in part: lines from a position on, or a number of bytes from an offset. What is read ahead of lines begins with a
/// page after every seek, and doubles while they go on: to look at tens of thousands of headers costs no more than their pages.
/// A file in UTF-16 or with lines that end with CR alone is read whole and stands for its plain_text().
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
  bool read_ahead();
  void fill(std::uint64_t offset, std::span<char> bytes);
  void take_plain_text();

  std::string name_;
  int descriptor_ = -1;
  std::string plain_;  ///< in place of the file where that needs it
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
  std::vector<char> ahead_;  ///< its first filled_ bytes are the file's from position_ - used_ on
  std::size_t filled_ = 0;
  std::size_t used_ = 0;   ///< of them, by lines that were given
  std::size_t block_ = 0;  ///< bytes to be read next
};

}  // namespace jointid::frf::uff
