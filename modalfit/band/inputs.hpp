#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"

namespace jointid::modalfit {

/// FRFs as outputs × inputs, the smaller side of the matrix being the inputs.
struct InputChoice {
  std::vector<std::size_t> inputs;  ///< chosen references, or responses when `transposed`
  std::size_t outputs = 0;
  bool transposed = false;

  /// Entry of the band; `input` counts in `inputs`.
  std::size_t entry(const Band& band, std::size_t output, std::size_t input) const {
    return transposed ? inputs[input] * band.references + output : output * band.references + inputs[input];
  }
};

/// Chooses at most `most` inputs whose weighted FRFs are least alike: pivoted Cholesky of their inner products over lines and
/// outputs (a subset of them where there are many).
InputChoice choose_inputs(const Band& band, std::size_t most);

}  // namespace jointid::modalfit
