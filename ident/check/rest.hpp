#pragma once

#include <string>
#include <vector>

#include "ident/check/test/screening.hpp"

namespace jointid::ident {

/// ", most from LO to HI Hz": the eighth of the lines whose χ² over its expectation is highest; empty where none is known.
std::string worst_band(const std::vector<Line>& lines, const std::vector<double>& by_line);

/// What no trial explains: driving points that are not passive, H_ij ≠ H_ji, an assembly that does not follow from its parts,
/// single numbers that make most of either; beyond what the noise of the files makes (Agreement), or by much. They name the
/// response, the reference, the band and the file that are worst. Lines that contradict all others (dropouts) do not count; with
/// `names_lines` they are a suspect of their own. `noise`: of each file, relative.
std::vector<Suspect> unexplained(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                                 const Screening& screening, const std::vector<double>& noise, bool names_lines);

/// Sentences about FRFs between coordinates of the joint that a part lacks.
std::vector<std::string> missing_points(const std::vector<CheckedFile>& files, const Dofs& joint);

}  // namespace jointid::ident
