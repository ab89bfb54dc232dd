#pragma once

#include <optional>

#include "ident/admissible/admissible_set.hpp"

namespace jointid::ident {

/// A θ that meets the set's ties and has S_k(θ) ≻ 0 for all `blocks`; empty when there is none. With blocks and unknowns scaled
/// by their known parts, t is raised towards 1 under S_k(θ) ⪰ tI at next to no price for the size of θ; there is one where
/// t > 1e-5.
std::optional<Eigen::VectorXd> interior_point(const std::vector<SymmetricBlock>& blocks, const AdmissibleSet& set, Eigen::Index unknowns);

/// The same for many unknowns: blocks without an unknown in common are asked one by one where there are no ties. With up to 150
/// unknowns it is interior_point() itself.
std::optional<Eigen::VectorXd> interior_point_by_parts(const std::vector<SymmetricBlock>& blocks, const AdmissibleSet& set,
                                                       Eigen::Index unknowns);

}  // namespace jointid::ident
