#pragma once

#include <optional>

#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// As much of a scene as can be read, whatever else is wrong or missing: the files of [data] (`parts` of a coupling scene are its
/// substructures) with what is stated of each, [frequency], and the DOFs of joints. It is there to look at data; nothing can be identified
/// from it. Empty where the text is no TOML or has no table [data].
std::optional<Scene> parse_readable(const std::string& text, const Path& file);

}  // namespace jointid::ident
