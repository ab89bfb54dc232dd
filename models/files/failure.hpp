#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::models {

/// Throws InputError (data) about a file.
[[noreturn]] inline void refuse_file(const std::filesystem::path& path, std::string place, std::string problem, std::string remedy = {}) {
  throw InputError({.kind = ErrorKind::data,
                    .file = path.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace jointid::models
