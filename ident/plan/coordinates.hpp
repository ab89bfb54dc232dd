#pragma once

#include <vector>

#include "frf/set/frf_system.hpp"
#include "ident/scene/scene.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

using Dofs = std::vector<frf::Dof>;

/// The DOFs of `first`, then those of `second`.
Dofs joined(Dofs first, const Dofs& second);

/// The DOFs, or none.
inline Dofs only_if(bool wanted, const Dofs& dofs) { return wanted ? dofs : Dofs(); }

/// The coordinates of a problem: joint DOFs, and the non-joint coordinates that both systems have.
struct Coordinates {
  Dofs joint;       ///< N, in the order of the scene
  Dofs responses;   ///< non-joint responses
  Dofs references;  ///< non-joint references
};

/// Which of the four named equations are used.
struct EquationSet {
  bool nn = false, nj = false, jj = false, jn = false;

  explicit EquationSet(const std::vector<Equation>& equations);
};

/// The scene's joint DOFs and the non-joint coordinates that both systems have in the same role. Throws InputError for a
/// joint DOF that no substructure has, with the nearest DOF of the files.
Coordinates find_coordinates(const Scene& scene, const restrictions::Restriction& restriction,
                             const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);

/// The equations that the scene names, or all that the data allow, in the order nn nj jj jn. Throws InputError that says
/// which FRFs a named equation lacks.
std::vector<Equation> choose_equations(const Scene& scene, const Coordinates& coordinates,
                                       const frf::FrfSystem& substructures, const frf::FrfSystem& assembly);

/// Of three parts and more: the equations of rows by parts (PartOfRows) that the scene names, or all that the data allow; empty
/// where there is none. They take motion at all joint coordinates of the assembly, and of the substructures forces there.
std::vector<Equation> equations_by_parts(const Scene& scene, const Coordinates& coordinates, const frf::FrfSystem& substructures,
                                         const frf::FrfSystem& assembly);

}  // namespace jointid::ident
