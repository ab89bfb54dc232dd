#pragma once

#include <string>

namespace jointid::ident {

/// A factor between units that are mistaken for each other.
struct UnitFactor {
  double factor = 1.0;
  std::string words;  ///< "g in place of m/s²"; empty: no such factor
};

/// The factor between units within `tolerance` (of its logarithm) of a measured one, or the measured one without words.
UnitFactor nearest_unit(double measured, double tolerance);

}  // namespace jointid::ident
