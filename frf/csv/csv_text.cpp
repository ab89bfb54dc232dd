#include "frf/csv/csv_text.hpp"

#include <string_view>

#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// Without the end-of-file byte of DOS and NULs that fill the last block.
std::string without_end_of_file(std::string text) {
  while (!text.empty() && (text.back() == '\x1A' || text.back() == '\0')) text.pop_back();
  return text;
}

void append_utf8(std::string& out, unsigned code) {
  const auto add = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    add(code);
  } else if (code < 0x800) {
    add(0xC0U | (code >> 6U));
    add(0x80U | (code & 0x3FU));
  } else {
    add(0xE0U | (code >> 12U));
    add(0x80U | ((code >> 6U) & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

}  // namespace

std::string read_csv_text(const std::filesystem::path& path) {
  std::string text = read_text(path);
  if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
  const bool little = text.starts_with("\xFF\xFE"), big = text.starts_with("\xFE\xFF");
  if (!little && !big) return without_end_of_file(std::move(text));
  std::string out;
  for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
    append_utf8(out, little ? byte(i) + 256U * byte(i + 1) : 256U * byte(i) + byte(i + 1));
  }
  return without_end_of_file(std::move(out));
}

}  // namespace jointid::frf
