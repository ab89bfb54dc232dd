#pragma once

#include <string>
#include <string_view>

namespace jointid::weighting {

/// Row weights of docs/formulas.md §5 (thesis §6.5 and §6.7); "largest" is by modulus of the complex element.
enum class Weighting {
  none,
  wa,   ///< after: one factor per line, largest element of E₀ᵀE₀ (after T_f and T) is 1
  wb,   ///< before: one factor per line, largest element of E is 1
  wbg,  ///< group: one factor per line, named equation and row of A, largest element in the group is 1
  wbs   ///< single: one factor per equation, largest element of the row is 1
};

std::string name(Weighting weighting);  ///< "none", "WA", "WB", "WBG", "WBS"

/// Parses a name; throws InputError (usage) with the nearest valid word.
Weighting parse_weighting(std::string_view text);

}  // namespace jointid::weighting
