#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::stability {

/// The FRFs that a plan was made on.
struct Sets {
  std::vector<frf::FrfSet> substructures, assembly;
};

struct ExactEstimate {
  std::vector<double> values;        ///< of the unknowns, SI
  std::vector<double> column_norms;  ///< ‖E_j‖ for the unknowns in SI: what they weigh in the equations
  double condition = 0.0;            ///< of the system with columns of unit length, up to 1e16
};

/// What the plan's identification (method one, two or direct, Δ = 0, every FRF measured, no bands) gives on the same FRFs in
/// exact arithmetic: all equations written out, weighted with the same weights, stacked, one Householder QR. 50 digits; the
/// 64-bit mantissa of long double instead where there are more than `most_exact_lines` lines.
inline constexpr std::size_t most_exact_lines = 200;
ExactEstimate identify_exactly(const ident::Plan& plan, const Sets& sets);

}  // namespace jointid::stability
