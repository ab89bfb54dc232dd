#include "frf/text/plain_text.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

#include "frf/text/label_text.hpp"
#include "frf/text/number_text.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";

/// Without end-of-file bytes of DOS and NULs that fill the last block, and ends of lines among them.
void remove_end_of_file(std::string& text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\x1A\0\r\n", 4));
  const std::size_t begin = last == std::string::npos ? 0 : last + 1;
  if (text.find_first_of(std::string_view("\x1A\0", 2), begin) != std::string::npos) text.replace(begin, std::string::npos, "\n");
}

/// Any number of "\r" before a "\n", "\r" alone and a form feed as "\n".
std::string with_plain_ends(std::string text) {
  if (text.find_first_of("\r\f") == std::string::npos) return text;
  std::size_t to = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    std::size_t end = at;
    while (end < text.size() && text[end] == '\r') ++end;
    if (end > at && end < text.size() && text[end] == '\n') at = end;
    text[to++] = text[at] == '\r' || text[at] == '\f' ? '\n' : text[at];
  }
  text.resize(to);
  return text;
}

/// Of UTF-16 without a mark, the bytes that are 0 in most characters: 1, the second of each (little-endian), or 0; 2 of other text.
std::size_t place_of_zeros(std::string_view text) {
  const std::string_view head = text.substr(0, 1024);
  const std::size_t last = head.find_last_not_of('\0');  // NULs that fill a block
  if (last == std::string_view::npos || last < 8) return 2;
  std::array<std::size_t, 2> zeros = {0, 0};
  for (std::size_t i = 0; i <= last; ++i) {
    if (head[i] == '\0') ++zeros[i % 2];
  }
  const std::size_t half = (last + 1) / 2;
  if (zeros[0] == 0 && 10 * zeros[1] > 8 * half) return 1;
  return zeros[1] == 0 && 10 * zeros[0] > 8 * half ? 0 : 2;
}

bool has_utf16_mark(std::string_view text) { return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"); }

}  // namespace

bool needs_plain_text(std::string_view head) {
  const bool utf16 = has_utf16_mark(head) || place_of_zeros(head) < 2;
  return utf16 || (head.find('\r') != std::string_view::npos && head.find('\n') == std::string_view::npos);
}

std::string plain_text(std::string text) {
  if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
  const bool marked = has_utf16_mark(text);
  const std::size_t zeros = marked ? (text.front() == '\xFF' ? 1U : 0U) : place_of_zeros(text);
  if (zeros < 2) {
    const bool little = zeros == 1;
    std::string out;
    for (std::size_t i = marked ? 2 : 0; i + 1 < text.size(); i += 2) {
      const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
      append_utf8(out, little ? byte(i) + 256U * byte(i + 1) : 256U * byte(i) + byte(i + 1));
    }
    text = std::move(out);
  }
  remove_end_of_file(text);
  return with_plain_ends(std::move(text));
}

std::string read_plain_text(const std::filesystem::path& path) { return plain_text(read_text(path)); }

}  // namespace jointid::frf
