#pragma once

#include <memory>

#include "frf/set/frf_system.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// The substructures with the pairs of couple_first coupled; the same system when there are none. Variances,
/// and which errors coupled FRFs have in common (frf::ErrorSums), are carried through where somebody asks, from the files or the law of
/// [noise].
/// Throws InputError as coupling::AssemblyReader, and for variance = "noise" with files that say their own.
std::shared_ptr<frf::FrfSystem> couple_first(Scene& scene, std::shared_ptr<frf::FrfSystem> substructures, std::vector<std::string>& notes);

}  // namespace jointid::ident
