#pragma once

#include <map>
#include <optional>
#include <string>

#include "ident/admissible/admissible_set.hpp"

namespace jointid::ident {

/// Column by unknown of one matrix of a joint, band by band; empty where all its elements are known.
std::map<std::optional<Range>, std::map<std::size_t, std::size_t>> columns_by_band(const Plan& plan, std::size_t joint,
                                                                                   restrictions::Kind kind);

/// The shortest text of a number.
std::string plain_number(double value);

/// Throws InputError for a scene that requires passive joints of which none has damping.
void require_damping(const Scene& scene);

/// Im Z_J(ω) = D + ωC ⪰ 0 of a joint whose first DOF is `first`, over the band that the scene requires to be passive. It is
/// affine in ω: what is semidefinite at both ends of the band is so between them. Nothing for a joint without damping. Throws
/// InputError for matrices that are not symmetric.
void add_passive(const Plan& plan, std::size_t joint, std::size_t first, AdmissibleSet& set);

}  // namespace jointid::ident
