#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jointid::ident {

/// One constraint on the joint and what came of it.
struct ConstraintOutcome {
  std::string text;          ///< "K positive semidefinite", "K(1,1) >= 0", the tie as the scene has it
  std::size_t size = 0;      ///< eigenvalues that the pattern leaves free to be zero; 1 for a bound, the number of ties
  std::size_t at_limit = 0;  ///< how many of these are zero: 0 when the constraint changes nothing
  double chi_square = 0.0;   ///< what it costs; the sum over the constraints is Admissibility::chi_square
};

/// What the constraints of a scene did to the estimate.
struct Admissibility {
  /// By how much χ² of the nearest joint that meets the constraints is above that of the best joint without them. Of method
  /// likelihood, the rise of its loss. Of linear methods, the rise of the weighted residual sum of squares over the mean square
  /// of the residuals of the best joint, residual sum/(rows − unknowns): errors of the coefficients, and rows that have errors in
  /// common, are not in that scale. NaN where there are no residuals.
  double chi_square = 0.0;
  /// Scalar equations that hold at the limit: a tie or bound counts 1, a matrix with q zero eigenvalues q(q+1)/2, or its unknowns
  /// where they are fewer. χ² of a true constraint is rarely above that of as many degrees of freedom.
  std::size_t equations = 0;
  bool from_variances = false;  ///< χ² by the variances of the FRFs; else by the residuals
  std::vector<ConstraintOutcome> constraints;
};

}  // namespace jointid::ident
