#pragma once

#include <string>

namespace jointid::cli {

/// A key as one reads it: "viscous_damping" is "viscous damping".
std::string words(std::string key);

}  // namespace jointid::cli
