#pragma once

#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Takes the pairs of couple_first out of the joints of a scene that was just read. With T the rigid connection x = T x', every
/// matrix of a joint, of [truth] and of the start becomes TᵀXT: entries are summed, springs between the two are dropped,
/// patterns hold for the coordinates that are left. A pair is deleted from its joint, and hidden, when nothing ties it to the
/// joint's other coordinates and no mass stands at it: a rigid joint without mass has nothing left to identify (docs/formulas.md §4).
/// Throws InputError (usage) when no joint is left.
void reduce_joints(Scene& scene);

}  // namespace jointid::ident
