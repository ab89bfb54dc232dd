#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace jointid::models {

/// How FRFs of a model are computed.
enum class ModelWay : std::uint8_t {
  modes,       ///< a sum over modes
  full,        ///< full matrices are factorised at each line
  factorised,  ///< sparse matrices are factorised at each line
  reduced      ///< by a Reduction
};

/// For whoever plans and reports.
struct ModelUse {
  ModelWay way = ModelWay::modes;
  std::string reason{};  ///< why a sparse model is factorised: a phrase; else empty
  std::size_t coordinates = 0;

  std::size_t factorizations = 0, reduced_lines = 0;  ///< so far
  std::size_t vectors = 0, shifts = 0;                ///< of the basis, so far
  double bound = 0.0;                                 ///< of `error`, up to which shifts are added; 0: not reduced
  double error = 0.0;                                 ///< estimated, largest at the test lines, over the largest FRF of the line
  double worst_hz = 0.0;                              ///< where that is

  /// Rough, of what is asked for: docs/model-parts.md has what was measured beside it. 0: not worth a word.
  double expected_bytes = 0.0, expected_seconds = 0.0;
  std::size_t expected_vectors = 0;
};

}  // namespace jointid::models
