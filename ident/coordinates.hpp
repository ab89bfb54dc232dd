#pragma once

#include "ident/equation_builder.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// The scene's joint DOFs and the non-joint coordinates that both systems have in the same role. Throws InputError for a
/// joint DOF that no substructure has, with the nearest DOF of the files.
Coordinates find_coordinates(const Scene& scene, const restrictions::Restriction& restriction,
                             const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);

/// The equations that the scene names, or all that the data allow, in the order nn nj jj jn. Throws InputError that says
/// which FRFs a named equation lacks.
std::vector<Equation> choose_equations(const Scene& scene, const Coordinates& coordinates,
                                       const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);

}  // namespace jointid::ident
