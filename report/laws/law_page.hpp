#pragma once

#include <string>

#include "laws/task/identify_laws.hpp"

namespace jointid::report {

/// One HTML page of an identification of friction laws.
std::string law_page(const laws::LawScene& scene, const laws::LawIdentification& found);

}  // namespace jointid::report
