#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "models/model_error.hpp"
#include "models/model_source.hpp"

namespace jointid::models {

/// Whether a file describes a model: it is named *.toml (docs/model-parts.md).
bool is_model_file(const std::filesystem::path& file);

/// The files that a description names. Throws InputError (usage) where it is not one.
std::vector<std::filesystem::path> files_of_model(const std::filesystem::path& file);

/// The model of a description. Throws InputError (usage) for keys that are not known, missing or exclude each other, and (data) for
/// files that do not hold what they should.
NamedModel read_model(const std::filesystem::path& file);

/// What a description states of its error, without a look at the files that it names. Throws InputError (usage) for bands that
/// overlap.
ModelError error_of_model(const std::filesystem::path& file);

/// The same as FRFs at the given lines.
std::unique_ptr<ModelSource> open_model(const std::filesystem::path& file, std::vector<double> frequency_hz);

}  // namespace jointid::models
