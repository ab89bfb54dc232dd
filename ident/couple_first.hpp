#pragma once

#include <memory>

#include "frf/frf_system.hpp"
#include "ident/scene.hpp"

namespace jointid::ident {

/// Takes the pairs of couple_first out of the joints of a scene that was just read. With T the rigid connection x = T x', every
/// matrix of a joint, of [truth] and of the start becomes TᵀXT: entries are summed, springs between the two are dropped,
/// patterns hold for the coordinates that are left. A pair is deleted from its joint, and hidden, when nothing ties it to the
/// joint's other coordinates and no mass stands at it: a rigid joint without mass has nothing left to identify (docs/formulas.md §4).
/// Throws InputError (usage) when no joint is left.
void reduce_joints(Scene& scene);

/// The substructures with the pairs of couple_first coupled; the same system when there are none. Variances
/// are carried through where somebody asks, from the files or the law of [noise]; that coupled FRFs have errors in common is not.
/// Throws InputError as coupling::AssemblyReader, and for variance = "noise" with files that say their own.
std::shared_ptr<frf::FrfSystem> couple_first(Scene& scene, std::shared_ptr<frf::FrfSystem> substructures, std::vector<std::string>& notes);

}  // namespace jointid::ident
