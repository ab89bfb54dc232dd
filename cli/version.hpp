#pragma once

#include <string>

namespace jointid::cli {

/// Name, version, and what this build can and cannot do.
std::string version_text();

}  // namespace jointid::cli
