#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// The lines that both systems have and the scene selects. Throws InputError when none is left.
std::vector<Line> choose_lines(const Scene& scene, frf::FrfSystem& substructures, frf::FrfSystem& assembly,
                               std::vector<std::string>& notes);

}  // namespace jointid::ident
