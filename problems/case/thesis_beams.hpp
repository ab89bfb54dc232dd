#pragma once

#include <string>

#include "problems/case/case.hpp"
#include "problems/structure/beam.hpp"

namespace jointid::problems {

/// The beam system of thesis §6.6.1: substructure A of three elements (nodes 1–4), B of two (nodes 5–7),
/// element length 0.3 m, 50 mm × 12 mm, ρ = 7547 kg/m³, E = 2.07e11 N/m², D = 0.001 K. Coordinate 2k−1 is
/// k:+Y, coordinate 2k is k:+RZ.
BeamSection thesis_section();
Structure substructure_a();

/// Substructure B, its density times `mass_factor`.
Structure substructure_b(double mass_factor = 1.0);

/// Node 4 to node 5: coordinates 7, 8, 9, 10.
std::vector<frf::Dof> thesis_joint_dofs();

/// The beam element between nodes 4 and 5 that most cases use as joint.
Matrix joint_stiffness();
Matrix joint_mass();

/// DOFs by the coordinate numbers of the thesis.
std::vector<frf::Dof> coordinates(const std::vector<int>& numbers);

/// Case A1: all coordinates, 400–1000 Hz in 31 lines, symmetric K and D, equations nn and nj, WA, 5 % uniform
/// noise.
Case basic_case(const std::string& name, const std::string& description);

/// Gives a case another joint and assembles it from its substructures.
void set_joint(Case& definition, std::vector<JointMatrix> joint);

}  // namespace jointid::problems
