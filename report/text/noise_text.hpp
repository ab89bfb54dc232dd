#pragma once

#include <optional>
#include <string>

#include "ident/scene/scene.hpp"

namespace jointid::report {

/// The errors that trials put on the data: "uniform, level 0.05".
std::string noise_text(const std::optional<ident::NoiseSection>& noise);

}  // namespace jointid::report
