#pragma once

#include <optional>
#include <string>

#include "frf/set/quantity.hpp"
#include "ident/result/solution.hpp"
#include "tasks/regenerate.hpp"

namespace jointid::report {

/// How results are shown to a reader. JSON stays in SI units.
struct Display {
  bool millimetres = false;                             ///< N, mm, s, rad: N/mm, N·mm/rad; masses stay in kg
  frf::Quantity quantity = frf::Quantity::receptance;  ///< of plotted FRFs
};

/// The same solution in these units: unknowns with their errors and intervals, matrices, minima. Unknowns whose unit is "mixed" stay.
ident::Solution in_units_of(const Display& display, ident::Solution solution);

/// Elements of joint matrices, rows and columns of `dofs`.
ident::Matrices in_units_of(const Display& display, ident::Matrices matrices, const ident::Dofs& dofs);

/// Receptances of SI units as the quantity and the units that are shown.
tasks::Regenerated in_units_of(const Display& display, tasks::Regenerated frfs);

/// A unit of SI as it is shown: shown = factor · SI. Others stay.
struct ShownUnit {
  std::string unit;
  double factor = 1.0;
};
ShownUnit shown_unit(const Display& display, const std::string& si);

/// From m/N, rad/(N·m) … to what is shown, of length alone.
double frf_factor(const Display& display, const frf::Dof& response, const frf::Dof& reference);

/// "SI units", or "N, mm, s".
std::string units_text(const Display& display);

/// "receptance (m/N)", "accelerance (mm/s²/N)", with rad and N·m for rotations.
std::string frf_label(const Display& display, const frf::Dof& response, const frf::Dof& reference);

}  // namespace jointid::report
