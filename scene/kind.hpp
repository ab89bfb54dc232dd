#pragma once

#include <filesystem>
#include <string>

namespace jointid::scene {

/// Whether a scene is one of friction laws: it has [[joint.friction]] or [[data.levels]]. Throws InputError (usage) for what is
/// no TOML.
bool is_law_scene(const std::string& text, const std::filesystem::path& file);

/// What a scene says, in one text: its keys and values in the order of the file, without its title, comments and spacing. Equal
/// for scenes that ask for the same. Throws InputError (usage) for what is no TOML.
std::string contents_of(const std::string& text, const std::filesystem::path& file);

/// Whether a scene asks for the joint at every line: its [joint], or one of its [[joints]], has `lines`. Throws as is_law_scene().
bool is_line_scene(const std::string& text, const std::filesystem::path& file);

}  // namespace jointid::scene
