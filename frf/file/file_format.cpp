#include "frf/file/file_format.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "base/error.hpp"
#include "frf/csv/analyser_file.hpp"
#include "frf/csv/csv_file.hpp"
#include "frf/csv/csv_titles.hpp"
#include "frf/file/other_format.hpp"
#include "frf/hdf5/hdf5_file.hpp"
#include "frf/hdf5/hdf5_writer.hpp"
#include "frf/mat/mat_file.hpp"
#include "frf/mat/mat_v4.hpp"
#include "frf/mat/octave_text.hpp"
#include "frf/npy/npy_file.hpp"
#include "frf/npy/npy_header.hpp"
#include "frf/text/plain_text.hpp"
#include "frf/uff/uff_file.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n";
constexpr std::string_view matlab_v5_text = "MATLAB 5.0 MAT-file";
constexpr std::size_t head_bytes = 4096;

[[noreturn]] void fail(const std::filesystem::path& path, std::string problem, std::string remedy) {
  throw InputError(
      {.kind = ErrorKind::data, .file = path.string(), .place = {}, .problem = std::move(problem), .remedy = std::move(remedy)});
}

/// The first bytes of a file that exists, can be read and is not empty.
std::string read_head(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) fail(path, "there is no such file", "check its path");
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

bool is_jointid_hdf5(const std::filesystem::path& path, std::string_view head) {
  return is_hdf5(head) && has_format_attribute(path);
}

bool is_matlab_v73(const std::filesystem::path&, std::string_view head) { return is_hdf5(head); }

bool is_matlab_v5(const std::filesystem::path&, std::string_view head) {
  return head.starts_with(matlab_v5_text) || looks_like_mat_v4(head);
}

bool is_npz(const std::filesystem::path&, std::string_view head) { return looks_like_npz(head); }

bool is_npy(const std::filesystem::path&, std::string_view head) { return looks_like_npy(head); }

/// Of text, which needs no look beyond its first bytes.
template <bool looks_like(std::span<const char>)>
bool is_text(const std::filesystem::path&, std::string_view head) {
  return looks_like(head);
}

bool is_analyser_text(const std::filesystem::path&, std::string_view head) {
  return looks_like_analyser_text(head) && !names_frfs(head);
}

std::unique_ptr<FrfSource> open_jointid_hdf5(const std::filesystem::path& path, const OpenOptions&) { return open_hdf5(path); }

void write_as_hdf5(const FrfSet& set, const std::filesystem::path& path) { write_hdf5(set, path); }

void write_own_quantity(const FrfSet& set, const std::filesystem::path& path) {
  write_uff(set, path, {.quantity = set.header.quantity});
}

/// The first of some formats that a file is of; null where it is of none.
template <class Among>
const Format* format_of(const std::filesystem::path& path, std::string_view head, Among among) {
  for (const Format& format : formats()) {
    if (among(format) && format.is_of(path, head)) return &format;
  }
  return nullptr;
}

template <class Among>
std::optional<FileFormat> detect(const std::filesystem::path& path, Among among) {
  const Format* found = format_of(path, read_head(path), among);
  return found != nullptr ? std::optional(found->format) : std::nullopt;
}

}  // namespace

const std::vector<Format>& formats() {
  static const std::vector<Format> all = {
      {.format = FileFormat::jointid_hdf5,
       .name = "HDF5 jointid-frf",
       .binary = true,
       .states_hertz = true,
       .is_of = is_jointid_hdf5,
       .open = open_jointid_hdf5,
       .extensions = {"h5", "hdf5"},
       .write = write_as_hdf5},
      {.format = FileFormat::matlab_v73,
       .name = "MATLAB v7.3",
       .binary = true,
       .variables = true,
       .is_of = is_matlab_v73,
       .open = open_mat_v73},
      {.format = FileFormat::matlab_v5,
       .name = "MATLAB v4 to v7",
       .binary = true,
       .variables = true,
       .is_of = is_matlab_v5,
       .open = open_mat_v5,
       .extensions = {"mat"},
       .write = write_mat},
      {.format = FileFormat::npz, .name = "numpy npz", .variables = true, .is_of = is_npz, .open = open_npz},
      {.format = FileFormat::npy, .name = "numpy npy", .variables = true, .is_of = is_npy, .open = open_npy},
      {.format = FileFormat::octave_text,
       .name = "Octave text",
       .variables = true,
       .is_of = is_text<looks_like_octave_text>,
       .open = open_octave_text},
      {.format = FileFormat::uff,
       .name = "UFF",
       .takes_unit = true,
       .is_of = is_text<looks_like_uff>,
       .open = open_uff,
       .extensions = {"uff", "unv"},
       .write = write_own_quantity},
      {.format = FileFormat::analyser_text,
       .name = "analyser text",
       .takes_unit = true,
       .is_of = is_analyser_text,
       .open = open_analyser_text},
      {.format = FileFormat::csv,
       .name = "CSV",
       .takes_unit = true,
       .is_of = is_text<looks_like_csv>,
       .open = open_csv,
       .extensions = {"csv"},
       .write = write_csv},
  };
  return all;
}

std::string name(FileFormat format) { return std::ranges::find(formats(), format, &Format::format)->name; }

const Format& format_of(const std::filesystem::path& path) {
  const std::string head = read_head(path);
  if (const Format* found = format_of(path, head, [](const Format&) { return true; })) return *found;
  require_read_format(path, head);
  if (const std::size_t line = line_without_titles(plain_text(head)); line > 0)
    fail(path, "holds numbers from line " + std::to_string(line) + " on without a row of titles, which states what each column holds",
         std::string(write_titles));
  fail(path, "begins with " + shown(head) + " and is no FRF file that this program knows",
       "give jointid-frf HDF5, UFF, MATLAB v4 to v7.3, CSV or the text export of an analyser. A table of text has a row of "
       "titles that begins with Frequency, and commas, semicolons, tabs or blanks between its columns");
}

FileFormat detect_format(const std::filesystem::path& path) { return format_of(path).format; }

std::optional<FileFormat> detect_binary_format(const std::filesystem::path& path) {
  return detect(path, std::mem_fn(&Format::binary));
}

std::optional<FileFormat> detect_array_format(const std::filesystem::path& path) {
  return detect(path, [](const Format& format) {
    return format.binary || format.format == FileFormat::npz || format.format == FileFormat::npy;
  });
}

}  // namespace jointid::frf
