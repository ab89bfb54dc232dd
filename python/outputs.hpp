#pragma once

#include <filesystem>
#include <vector>

#include "ident/scene/scene_files.hpp"

namespace jointid::python {

/// Throws InputError (usage) where a file that is to be written is one of those that are read.
void refuse_inputs(const std::filesystem::path& target, const std::vector<ident::NamedFile>& inputs);

}  // namespace jointid::python
