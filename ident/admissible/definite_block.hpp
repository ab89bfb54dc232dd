#pragma once

#include <map>
#include <optional>

#include "ident/admissible/symmetric_block.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {

/// A matrix of a joint in a condition: factor · (known + unknown elements · `unit`), elements SI.
struct BlockPart {
  const restrictions::MatrixTerms& matrix;
  const std::map<std::size_t, std::size_t>& column_of;  ///< the column of each of its unknowns
  double unit = 1.0;                                    ///< SI value of an unknown of 1
  double factor = 1.0;
};

/// The rows and columns [first, first + count) of the sum of matrices as a condition X ⪰ 0 in units of `unit`; see below.
std::optional<SymmetricBlock> definite_block(const std::vector<BlockPart>& parts, std::size_t first, std::size_t count, double unit);

/// The rows and columns [first, first + count) of a matrix X(θ) as a condition X ⪰ 0; `column_of` tells the column of each of
/// its unknowns, and elements are divided by `unit`. Every X of a pattern may be singular, like that of a joint that is free to
/// move as a rigid body: then X = Q S Qᵀ with QᵀQ = I, Q spanning all that the coefficients reach, and the condition is S ⪰ 0.
/// Empty when X is not symmetric.
std::optional<SymmetricBlock> definite_block(const restrictions::MatrixTerms& matrix, std::size_t first, std::size_t count,
                                             const std::map<std::size_t, std::size_t>& column_of, double unit);

}  // namespace jointid::ident
