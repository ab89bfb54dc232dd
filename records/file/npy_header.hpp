#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::records {

/// What stands before the numbers of an .npy file.
struct NpyHeader {
  char kind = 'f';  ///< f floating point, i signed, u unsigned
  std::size_t width = 8;
  bool big_endian = false;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
};

/// Parses the text {'descr': '<f8', 'fortran_order': False, 'shape': (3, 25600), }. Throws InputError (data) naming what is
/// wrong.
NpyHeader parse_npy_header(std::string_view text, const std::filesystem::path& path);

/// Throws InputError (data) about the header.
[[noreturn]] void fail_npy(const std::filesystem::path& path, std::string problem, std::string remedy = {});

}  // namespace jointid::records
