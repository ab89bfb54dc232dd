#pragma once

#include <filesystem>
#include <string>

namespace jointid::scene {

/// The bytes of a scene file, at most 16 MiB. Throws InputError (usage) when there is no such file, it is a folder,
/// cannot be read or is larger.
std::string read_text(const std::filesystem::path& file);

/// Throws InputError (usage) when a key has more than 32 parts (`a.b.c…`). The TOML parser bounds nested values but not
/// dotted keys, and a table nested a million deep overflows the stack where it is destroyed.
void check_key_depth(const std::string& text, const std::filesystem::path& file);

}  // namespace jointid::scene
