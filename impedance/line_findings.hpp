#pragma once

#include <functional>

#include "ident/plan/plan.hpp"
#include "impedance/line_result.hpp"

namespace jointid::impedance {

/// χ² and degrees of freedom of all lines with a symmetric Z in place of the scene's structure; degrees 0: it explains anything.
struct FreeFit {
  enum class Kind {
    first_order,  ///< where the structure's own fit ended (fall_with())
    fitted
  };
  double chi_square = 0.0, freedom = 0.0;
};

/// Of the lines that have a value.
FreeFit total_of(const std::vector<std::optional<LineValue>>& lines);

using MakeFreeFit = std::function<FreeFit(FreeFit::Kind)>;

/// Holds the lines against their data: fills χ², status, message and notes.
///   poor_fit  χ²/f of all lines above 2 where variances are known, 4 where some are estimated;
///   doubtful  χ²/f of all lines, or of a run of 3 to 20, above what chance leaves (ident::likely_chi_square()); a symmetric Z
///   explains what
///             the structure does not; nothing could contradict the answer (no degrees of freedom); Im Z is negative beyond its
///             error on a run of lines; a closed form is five of its standard errors from the likelihood on a run.
void judge_lines(const ident::Plan& plan, const LineScene& scene, const MakeFreeFit& free_fit, IdentifiedLines& out);

/// First and last line of the longest run of at least three lines of which `is_bad` is true; empty where there is none.
std::optional<std::pair<std::size_t, std::size_t>> bad_run(std::size_t lines, const std::function<bool(std::size_t)>& is_bad);

/// Whether the smallest eigenvalue of Im Z, scaled by the size of its diagonal, is negative beyond 1 + √T standard errors, T
/// elements. Motions that no element of the basis resists do not count.
bool is_active(const Basis& basis, const LineValue& value);

}  // namespace jointid::impedance
