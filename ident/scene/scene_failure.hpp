#pragma once

#include <string>

#include "base/error.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Throws InputError (usage) about a place of the scene.
[[noreturn]] inline void fail(const Scene& scene, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = scene.file.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace jointid::ident
