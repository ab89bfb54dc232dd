#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace jointid::frf {

struct OtherFormat {
  std::string_view name, remedy;
};

/// What the first bytes of a file are of, where that is known and not read: packed files, workbooks, sound, formats of data
/// loggers and of other languages. Empty where they are of none of these.
std::optional<OtherFormat> other_format(std::string_view head);

/// Throws InputError (data) that names the format and the remedy where a file is of one that is not read.
void require_read_format(const std::filesystem::path& path, std::string_view head);

}  // namespace jointid::frf
