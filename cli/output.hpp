#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace jointid::cli {

/// An option and the target that it was given, if any.
using OptionTarget = std::pair<std::string, std::optional<std::string>>;

/// Throws InputError for what would go wrong after a long run and can be seen before it: an empty name, one target for two
/// results, the scene as a target (usage); a folder, or a folder that is not there. Nothing is written.
void check_targets(const std::filesystem::path& scene, const std::vector<OptionTarget>& targets);

/// Whether one of the targets is standard output, so that nothing else may go there.
bool takes_output(const std::vector<std::optional<std::string>>& targets);

/// Writes to `out` when the target is "-", else to the file of that name, whole or not at all.
void write_target(const std::string& target, const std::string& text, std::ostream& out);

}  // namespace jointid::cli
