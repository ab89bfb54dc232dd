#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"

namespace jointid::ident {

/// Weights 1/σ of the elements of a line whose errors are circular.
struct ElementWeights {
  Eigen::VectorXd all;          ///< in the order x, y, a, b, d; 0: not measured
  Eigen::VectorXd own_squared;  ///< squares of those of X and Y; of a guess (guessed_weight()) where they are not measured

  void take(const LineLayout& layout, const LineData& data, const LineState& state);
};

}  // namespace jointid::ident
