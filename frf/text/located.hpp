#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::frf {

/// Runs `parse`; an InputError that it throws becomes a data error of `file` at `place`, so that parsers of
/// words (DOFs, quantities, units) need not know where a word came from.
template <class Parse>
auto located(const std::string& file, const std::string& place, Parse&& parse) {
  try {
    return std::forward<Parse>(parse)();
  } catch (const InputError& error) {
    InputError::Parts parts = error.parts();
    parts.kind = ErrorKind::data;
    parts.file = file;
    parts.place = place;
    throw InputError(std::move(parts));
  }
}

}  // namespace jointid::frf
