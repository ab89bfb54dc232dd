#pragma once

#include <string>
#include <utility>

#include "base/error.hpp"

namespace jointid::cli {

/// Parses the value of an option; an InputError in it is one of use and names the option.
template <class Parse>
auto of_option(const std::string& name, Parse&& parse) {
  try {
    return std::forward<Parse>(parse)();
  } catch (const InputError& error) {
    throw InputError({ErrorKind::usage, "", name, error.parts().problem, error.parts().remedy});
  }
}

}  // namespace jointid::cli
