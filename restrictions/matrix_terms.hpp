#pragma once

#include <cstddef>
#include <vector>

#include "restrictions/joint_spec.hpp"

namespace jointid::restrictions {

/// Coefficient of an unknown in one matrix element: X(row, column) += coefficient · y(unknown).
struct Term {
  std::size_t row = 0;
  std::size_t column = 0;
  std::size_t unknown = 0;  ///< index into Restriction::unknowns
  double coefficient = 0.0;
};

/// Known part of one matrix element: X(row, column) += value.
struct Known {
  std::size_t row = 0;
  std::size_t column = 0;
  double value = 0.0;
};

/// One of K, M, C, D: X = Σ_terms coefficient·y(unknown) + known, N×N in the order of Restriction::dofs.
struct MatrixTerms {
  Kind kind = Kind::stiffness;
  std::vector<Term> terms;   ///< sorted by (unknown, row, column), no element twice per unknown
  std::vector<Known> known;  ///< sorted by (row, column), non-zero only
};

}  // namespace jointid::restrictions
