#pragma once

#include <string>

#include "cli/pod/pod_report.hpp"

namespace jointid::cli {

/// The page of `jointid pod`: values, shapes, what they are most alike to.
std::string pod_report(const PodReport& report);

}  // namespace jointid::cli
