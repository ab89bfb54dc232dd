#pragma once

#include <string>

#include "models/modal_model.hpp"
#include "models/model_dofs.hpp"
#include "models/structure_matrices.hpp"
#include "scene/reader.hpp"

namespace jointid::models {

/// Units of the numbers that a description names, in SI units. Rotations are in rad, times in s.
struct ModelUnits {
  double length = 1.0, force = 1.0, mass = 1.0;

  /// In SI units: forces over lengths, and rows of rotations, whose moments are in force times length.
  void apply(StructureMatrices& matrices, const NamedCoordinates& coordinates) const;
  void apply(Modes& modes, const NamedCoordinates& coordinates) const;
};

/// Of "mm, N", "mm, N, t", "in, lbf" or "N, mm, kg": a length and a force, and a mass, else force over length times s². Throws
/// InputError (usage) for other words.
ModelUnits read_model_units(const scene::Item& item);

/// What to do about matrices whose file states units.
inline constexpr const char* give_model_units =
    "models are in SI units: give their own beside them, e.g. units = \"mm, N, t\", or write N/m and kg";

}  // namespace jointid::models
