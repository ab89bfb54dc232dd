#pragma once

#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// FRFs that a plan uses and that stand a thousandfold out of their neighbour lines (frf::WildSearch, large), on lines of the plan.
struct WildLines {
  std::vector<std::string> named;  ///< "the accelerance of 3:+Z over 7:+Z in S.h5 at 340 Hz is 1e+135, 2e+134 times its neighbour lines"
  std::vector<double> absurd_hz;   ///< lines with one that is more than a millionfold out: no structure has that
  std::vector<std::string> absurd; ///< their names
};

/// Reads all FRFs of the files about the plan's lines, at most a million numbers; of more nothing is looked at.
WildLines find_wild_lines(const Plan& plan, const Control& control);

}  // namespace jointid::ident
