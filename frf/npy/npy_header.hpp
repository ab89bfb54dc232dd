#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jointid::frf {

/// A field of records, flat: of ('coordinate', [('node', '<u8'), ('direction', '|i1')], (2,)) coordinate.node and
/// coordinate.direction.
struct NpyField {
  std::string name;
  char kind = 'f';  ///< as of NpyHeader
  std::size_t width = 8;
  bool big_endian = false;
  std::size_t offset = 0;  ///< of its first element in the record
  std::size_t count = 1, stride = 8;
};

/// What stands before the numbers of an array of numpy.
struct NpyHeader {
  char kind = 'f';  ///< f floating point, i signed, u unsigned, c complex, b true or false, U text in UTF-32, S bytes of text, O
                    ///< objects of Python, V records
  std::size_t width = 8;  ///< bytes of an element
  bool big_endian = false;
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
  std::size_t begin = 0;  ///< of the numbers, after the first byte of the file
  std::vector<NpyField> fields{};  ///< of records

  bool is_real() const { return kind == 'f' || kind == 'i' || kind == 'u'; }
};

inline constexpr std::size_t longest_npy_header = 65536 + 12;

/// Whether bytes begin as an array of numpy does.
bool looks_like_npy(std::string_view first_bytes);

/// Parses the beginning of an array that numpy.save() wrote (formats 1.0, 2.0 and 3.0), {'descr': '<f8', 'fortran_order': False,
/// 'shape': (3, 25600), } after its magic; `first_bytes` are at least longest_npy_header or all that there are. Strict: the keys
/// are those that numpy writes, each once, in types of numpy's plain numbers and texts, and records of them. Throws InputError
/// (data) naming `file`
/// and what is wrong.
NpyHeader parse_npy_header(std::string_view first_bytes, const std::string& file);

/// Throws InputError (data) about the header.
[[noreturn]] void fail_npy(const std::string& file, std::string problem, std::string remedy = {});

/// "holds numbers of type '<c16'"
std::string npy_type_text(const NpyHeader& header);

}  // namespace jointid::frf
