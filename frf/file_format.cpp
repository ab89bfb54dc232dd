#include "frf/file_format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "frf/analyser_file.hpp"
#include "frf/csv_file.hpp"
#include "base/error.hpp"
#include "frf/hdf5_file.hpp"
#include "frf/uff_file.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
constexpr std::string_view matlab_v5_text = "MATLAB 5.0 MAT-file";
constexpr std::size_t head_bytes = 4096;

[[noreturn]] void fail(const std::filesystem::path& path, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = path.string(),
                    .place = {},
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

/// The first bytes of a file that exists, can be read and is not empty.
std::string read_head(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    fail(path, "there is no such file", "check its path");
  if (error) fail(path, "cannot be opened: " + error.message(), "check its path and the permissions of its folders");
  if (is_directory(status)) fail(path, "is a folder", "name a file in it");
  if (!is_regular_file(status)) fail(path, "is not a regular file", "copy its data into one");
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(path, std::string("cannot be opened: ") + std::strerror(errno), "check its permissions");
  std::string head(head_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (head.empty()) fail(path, "is empty", "write or copy it again");
  return head;
}

/// The signature stands at 0, or after a user block of 512, 1024, … bytes (512 in MATLAB v7.3).
bool is_hdf5(std::string_view head) {
  for (std::size_t at = 0; at < head.size(); at = std::max<std::size_t>(512, 2 * at)) {
    if (head.substr(at).starts_with(hdf5_signature)) return true;
  }
  return false;
}

/// The first bytes as text, or in hexadecimal when they are none.
std::string shown(std::string_view head) {
  std::string text(head.substr(0, std::min<std::size_t>(24, head.find_first_of("\r\n"))));
  if (!text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isprint(c) != 0; })) {
    return "'" + text + "'";
  }
  constexpr std::string_view digits = "0123456789abcdef";
  std::string bytes = "bytes";
  for (const char c : head.substr(0, 8)) {
    const auto byte = static_cast<unsigned char>(c);
    bytes += std::string(" ") + digits[byte / 16] + digits[byte % 16];
  }
  return bytes;
}

std::optional<FileFormat> binary_format(const std::filesystem::path& path, std::string_view head) {
  if (is_hdf5(head)) return has_format_attribute(path) ? FileFormat::jointid_hdf5 : FileFormat::matlab_v73;
  if (head.starts_with(matlab_v5_text)) return FileFormat::matlab_v5;
  return std::nullopt;
}

}  // namespace

std::string name(FileFormat format) {
  constexpr std::array<const char*, 6> names = {"HDF5 jointid-frf", "UFF", "MATLAB v5 to v7", "MATLAB v7.3", "CSV", "analyser text"};
  return names[static_cast<std::size_t>(format)];
}

FileFormat detect_format(const std::filesystem::path& path) {
  const std::string head = read_head(path);
  if (const auto binary = binary_format(path, head)) return *binary;
  if (looks_like_uff(head)) return FileFormat::uff;
  if (looks_like_analyser_text(head)) return FileFormat::analyser_text;
  if (looks_like_csv(head)) return FileFormat::csv;
  fail(path, "begins with " + shown(head) + " and is no FRF file that this program knows",
       "give jointid-frf HDF5, UFF, MATLAB v5 to v7.3, CSV or the text export of an analyser");
}

std::optional<FileFormat> detect_binary_format(const std::filesystem::path& path) {
  return binary_format(path, read_head(path));
}

}  // namespace jointid::frf
