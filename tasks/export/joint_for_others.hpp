#pragma once

#include <string>
#include <vector>

#include "ident/result/solution.hpp"

namespace jointid::tasks {

/// A joint as other programs take it. Its DOFs have positive directions: rows and columns of those with a minus sign are turned.
struct ExportedJoint {
  std::string source;          ///< the scene or result that it comes from
  std::string status;          ///< of the identification
  std::vector<frf::Dof> dofs;  ///< N, of positive sign
  ident::Matrices matrices;    ///< K, M, C, D, N×N, SI units; a matrix that the joint does not have is absent
  ident::Matrices errors;      ///< standard errors of their elements; NaN where they are not known, 0 of known elements
  std::vector<ident::Estimate> unknowns;
  ident::Matrix covariance;  ///< of the unknowns, SI units, in their order; NaN where it is not known
};

}  // namespace jointid::tasks
