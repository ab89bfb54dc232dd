#pragma once

#include "base/text.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Relative error above which an estimate leaves the linear range: intervals are approximate, and other minima may fit as well.
constexpr double nonlinear_error = 0.3;

/// A combination as text, its largest factor 1: "K(2,4) - 0.9*K(4,4)".
std::string text(const LinearCombination& combination);

/// One sentence on a combination that the data fix badly.
std::string text(const WeakCombination& weak);

/// What to say about combinations, joint and intervals of `found`, and about χ² of `fit` on the lines `frequency_hz`:
///   weak_combination  deviation ≥ 10 %;
///   soft_joint        effect < 5, deformation > 0.5 and some error ≥ 10 % (docs/formulas.md §11i, thesis §6.8.2);
///   stiff_joint       deformation < 0.01 and some error ≥ 10 % (thesis §6.8.3, §6.8.5, §6.9), with the stiff pairs as the
///                     line couple_first of a scene;
///   nonlinear         an error ≥ 30 %, unless the intervals are those of the bootstrap;
///   misfit            χ² > f + 5√(2f), f its degrees of freedom, and beyond `likely` times f, which estimated variances leave.
std::vector<Finding> findings_of(const Identifiability& found, const Fit& fit, IntervalKind intervals,
                                 const std::vector<double>& frequency_hz, double likely = 0.0);

}  // namespace jointid::ident
