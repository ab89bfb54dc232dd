#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_factors.hpp"
#include "ident/likelihood/line/way_back.hpp"

namespace jointid::ident {

/// What the elements of a line (in the order x, y, a, b, d) change by with all that is not an FRF of it, and what they are off
/// by: complex columns, not weighted. Unknowns of a joint that act by the same matrix times a number of their own, as stiffness
/// and damping of one spring do, have one column.
struct RightSides {
  ComplexMatrix values;           ///< elements × columns; the last one has measured − predicted, 0 where nothing is measured
  Eigen::Index first_error = 0, errors = 0;  ///< columns of systematic errors, which have few elements each
  std::vector<SharedColumn> unknowns;  ///< the joint's, then those of systematic errors
};

/// Of the joint's unknowns, if there is one, and of the systematic errors that `data` is corrected for, if `terms` are given.
void take_right_sides(const LineLayout& layout, const LineData& data, const LineState& state, const LineFactors& factors,
                      const JointImpedance* joint, const SystematicTerms* terms, RightSides& out);

}  // namespace jointid::ident
