#pragma once

#include <string>
#include <vector>

#include "ident/scene.hpp"

namespace jointid::cli {

/// A key as one reads it: "viscous_damping" is "viscous damping".
std::string words(std::string key);

/// "nn nj"; "all" for none, which stands for all that the data allow.
std::string equations_text(const std::vector<ident::Equation>& equations);

}  // namespace jointid::cli
