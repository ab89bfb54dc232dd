#include "frf/csv/csv_text.hpp"

#include <string_view>
#include <utility>

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

std::string plain_text(std::string text) {
  if (text.starts_with(utf8_mark)) text.erase(0, utf8_mark.size());
  const bool little = text.starts_with("\xFF\xFE"), big = text.starts_with("\xFE\xFF");
  if (little || big) {
    std::string out;
    for (std::size_t i = 2; i + 1 < text.size(); i += 2) {
      const auto byte = [&](std::size_t at) { return static_cast<unsigned>(static_cast<unsigned char>(text[at])); };
      append_utf8(out, little ? byte(i) + 256U * byte(i + 1) : 256U * byte(i) + byte(i + 1));
    }
    text = std::move(out);
  }
  remove_end_of_file(text);
  return with_plain_ends(std::move(text));
}

std::string read_csv_text(const std::filesystem::path& path) { return plain_text(read_text(path)); }

}  // namespace jointid::frf
