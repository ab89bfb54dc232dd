#pragma once

#include "impedance/line_result.hpp"

namespace jointid::impedance {

/// Which elements of a result follow laws: those of z between facing halves, where a symmetric Z has facing DOFs too; else all.
/// Masses stand at the diagonal elements of the joint's DOFs. Throws InputError (usage) where elements have no place for masses.
LawLayout law_layout(const LineScene& scene, const WayResult& result);

/// Fits the scene's laws to the first way, and says what the lines make of them: doubtful where the best law's χ² is beyond what
/// chance leaves; a note with the runner-up, its ΔAIC and the band that tells them apart.
void add_laws(const LineScene& scene, IdentifiedLines& out);

/// Smooths every element of the first way by itself, with its own variances. A note where lines are too few.
void add_smooth(const LineScene& scene, IdentifiedLines& out);

}  // namespace jointid::impedance
