#pragma once

#include <string>

#include "laws/task/direct_identification.hpp"

namespace jointid::report {

/// One HTML page of the direct step: stiffness and damping over motion, measured loops, before any law.
std::string direct_page(const laws::LawScene& scene, const laws::DirectIdentification& found);

}  // namespace jointid::report
