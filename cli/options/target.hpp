#pragma once

#include <optional>
#include <string>

namespace jointid::cli {

/// Where a result goes: a file name, or "-" for standard output.
using Target = std::optional<std::string>;

}  // namespace jointid::cli
