#pragma once

#include "ident/admissible/admissible_set.hpp"

namespace jointid::ident {

/// Whether some θ that meets the set's ties has S_k(θ) ≻ 0 for all `blocks`. With blocks and unknowns scaled by their known
/// parts, t is raised towards 1 under S_k(θ) ⪰ tI at next to no price for the size of θ; room is t > 1e-5.
bool has_room(const std::vector<SymmetricBlock>& blocks, const AdmissibleSet& set);

}  // namespace jointid::ident
