#pragma once

#include <string>

namespace jointid::cli {

/// "0.2.0"
std::string version_number();

/// Name, version, and what this build can and cannot do.
std::string version_text();

}  // namespace jointid::cli
