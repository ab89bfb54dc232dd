#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace jointid::frf {

/// The whole of a text file by plain_text(). Throws InputError when it cannot be read.
std::string read_plain_text(const std::filesystem::path& path);

/// Text as other programs write it as UTF-8 (or bytes of a code page) with "\n" behind each line: without a byte-order mark,
/// end-of-file bytes of DOS and NULs at its end; UTF-16, with a mark or without, is converted; "\r\n", "\r\r\n", "\r" alone
/// and a form feed end a line.
std::string plain_text(std::string text);

/// Whether a file that begins so is UTF-16, or its lines end with "\r" alone.
bool needs_plain_text(std::string_view head);

}  // namespace jointid::frf
