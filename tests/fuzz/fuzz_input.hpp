#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace jointid::fuzz {

/// A file without a place on a disk that holds the bytes of one run.
class InputFile {
 public:
  explicit InputFile(std::span<const std::uint8_t> bytes);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  int descriptor_;
  std::filesystem::path path_;
};

/// What reading a file may take: bytes live at once, at most base + per_byte · size of the file.
struct Allowance {
  std::size_t base = std::size_t{1} << 20;
  std::size_t per_byte = 64;
};

/// Calls read(path) for a file of these bytes. InputError is an answer; all else ends the run: another exception, a crash, and
/// more memory than allowed.
void expect_answer(std::span<const std::uint8_t> bytes, const Allowance& allowance,
                   const std::function<void(const std::filesystem::path&)>& read);

}  // namespace jointid::fuzz
