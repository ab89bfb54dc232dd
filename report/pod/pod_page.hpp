#pragma once

#include <string>

#include "tasks/pod/run_pod.hpp"

namespace jointid::report {

/// The page of `jointid pod`: values, shapes, what they are most alike to.
std::string pod_page(const tasks::PodResult& report);

}  // namespace jointid::report
