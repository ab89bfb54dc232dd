#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/complex.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Z_j(θ) of one line: the places of every unknown in it, and what is known.
struct LineJoint {
  /// One matrix element that an unknown stands at.
  struct Place {
    Eigen::Index row, column;
    Complex factor;
  };

  std::vector<std::size_t> columns;  ///< of the whole problem, one per unknown of the restriction; empty: in no band
  std::vector<std::vector<Place>> unknowns;
  Eigen::MatrixXcd known;

  Eigen::MatrixXcd at(const std::vector<double>& theta) const;
};

LineJoint joint_at(const Plan& plan, double frequency_hz);

}  // namespace jointid::ident
