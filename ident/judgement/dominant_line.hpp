#pragma once

#include <optional>
#include <string>

#include "ident/judgement/line_jackknife.hpp"

namespace jointid::ident {

/// One line that decides a linear estimate against all others.
struct DominantLine {
  double frequency_hz = 0.0;
  std::size_t column = 0;            ///< the unknown that it moves most, by the errors of the other lines
  double with = 0.0, without = 0.0;  ///< its value, scaled, by all lines and without this one
  std::string frf;  ///< "5:+Y/102:+Y of the assembly", where one FRF is far from its neighbours at this line; else empty
  double over_neighbours =
      0.0;  ///< its magnitude there over that of the larger neighbour, or of the smaller one where that is less
};

/// A line without which an unknown moves by more than eight errors of what the other lines say (their own scatter), and by more
/// than a twentieth of the largest unknown of its matrix and unit; looked for in the group without which the weighted residuals
/// fall by half. Lines that the jackknife left out are looked at where the estimate of all lines, `y`, is as far from that of the
/// jackknife. Empty where there is none.
std::optional<DominantLine> dominant_line(const Plan& plan, LineJackknife& jackknife, const std::vector<double>& y,
                                          const Control& control);

}  // namespace jointid::ident
