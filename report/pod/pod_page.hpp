#pragma once

#include <string>

#include "report/pod/pod_report.hpp"

namespace jointid::report {

/// The page of `jointid pod`: values, shapes, what they are most alike to.
std::string pod_page(const PodReport& report);

}  // namespace jointid::report
