#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"
#include "frf/frf_set.hpp"

namespace jointid::frf {

/// Throws InputError (data) about a place of the file that a header belongs to.
[[noreturn]] inline void fail(const FrfHeader& header, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

}  // namespace jointid::frf
