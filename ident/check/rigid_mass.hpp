#pragma once

#include <optional>

#include "ident/check/test/checked_file.hpp"

namespace jointid::ident {

/// The mass (kg) that the rigid-body lines of a free structure tell. At its lowest lines −ω²H of the coordinates that are
/// translations of one direction d, in both roles, is A = 1 1ᵀ/m + rotations, so that m = 1ᵀA⁺1; where rotations are not told
/// apart, and where elasticity adds to A, that is less than m. Read off at the lines up to twice the first above 0 Hz, at least
/// three, extrapolated to 0 Hz, for the direction with the most coordinates. Empty where those lines are fewer than three, or do
/// not agree on a mass within a tenth: not free, or not rigid there.
std::optional<double> rigid_body_mass(const CheckedFile& file);

/// Files whose rigid-body lines contradict the mass that the scene gives for them: a structure that is heavier than it was
/// weighed, or lighter by a factor between units. The file is put right; where the files agree with each other as they are, all of them,
/// as the unit is that of all.
std::vector<Suspect> find_wrong_masses(std::vector<CheckedFile>& files, const Dofs& joint);

}  // namespace jointid::ident
