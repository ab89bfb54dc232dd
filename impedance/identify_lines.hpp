#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "ident/result/control.hpp"
#include "impedance/line_result.hpp"

namespace jointid::impedance {

/// Z_J at every line of the scene's files. Throws InputError as ident::make_plan() does, for gains and masses that are not known,
/// and for data that no way can start from.
IdentifiedLines identify_lines(const LineScene& scene, const ident::Control& control = {});

/// The same on FRFs in memory.
IdentifiedLines identify_lines(const LineScene& scene, std::vector<frf::FrfSet> substructures, std::vector<frf::FrfSet> assembly,
                               const ident::Control& control = {});

/// The unknowns of the scene's structure at a line.
std::vector<ElementName> elements_of(const LineScene& scene);

}  // namespace jointid::impedance
