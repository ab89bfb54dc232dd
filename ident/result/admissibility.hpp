#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace jointid::ident {

/// One constraint on the joint and its effect.
struct ConstraintOutcome {
  std::string text;          ///< "K positive semidefinite", "K(1,1) >= 0", the tie as the scene has it
  std::size_t size = 0;      ///< eigenvalues that the pattern leaves free to be zero; 1 for a bound, the number of ties
  std::size_t at_limit = 0;  ///< number of these that are zero; 0: the constraint has no effect
  double chi_square = 0.0;   ///< its cost; the sum over the constraints is Admissibility::chi_square
};

/// Effect of the constraints of a scene on the estimate.
struct Admissibility {
  /// χ² of the nearest admissible joint minus χ² of the best joint without constraints. Method likelihood: the rise of its loss.
  /// Linear methods: the rise of the weighted residual sum of squares over the mean square of the residuals of the best joint,
  /// residual sum/(rows − unknowns). That scale leaves out errors of the coefficients and correlated rows. NaN if there are no
  /// residuals.
  double chi_square = 0.0;
  /// Number of scalar equations at the limit. A tie or bound counts 1, a matrix with q zero eigenvalues q(q+1)/2, or its unknowns
  /// if they are fewer. χ² of a true constraint is rarely above that of as many degrees of freedom.
  std::size_t equations = 0;
  bool from_variances = false;  ///< χ² by the variances of the FRFs; else by the residuals
  std::vector<ConstraintOutcome> constraints;
};

}  // namespace jointid::ident
