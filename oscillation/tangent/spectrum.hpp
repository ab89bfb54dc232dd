#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// Advances a state by one step of a model and every column of `tangents` by the step's derivative there.
using TangentStep = std::function<void(Eigen::VectorXd& state, Eigen::MatrixXd& tangents)>;

struct SpectrumOptions {
  std::size_t count = 1;      ///< exponents, the largest first; ≥ 1
  std::size_t transient = 0;  ///< steps before the averages
  std::size_t steps = 10000;  ///< ≥ blocks
  std::size_t blocks = 20;    ///< ≥ 2, of equal length: batch means
  double step_time = 1.0;     ///< s, > 0; 1 for maps: nats per iteration
};

/// Exponents of a model (Benettin et al. 1980): tangent vectors made orthonormal after every step. Where a step has no inverse
/// (rigid sticking loses a dimension) the exponents behind the rank are −infinity.
struct Spectrum {
  std::vector<double> exponent;            ///< nats per second
  std::vector<double> standard_error;      ///< from the scatter of the blocks
  std::vector<std::vector<double>> block;  ///< [exponents, blocks]
};

/// `free`: the coordinates of the state that may differ (not constants or the phase of a drive); all where empty. The tangents
/// begin as columns of a fixed random matrix.
Spectrum lyapunov_spectrum(const TangentStep& step, Eigen::VectorXd state, const SpectrumOptions& options,
                           const std::vector<Eigen::Index>& free = {});

/// Makes the columns orthonormal from left to right (Gram–Schmidt, twice) and returns their lengths before. A column that is 0
/// beside those to its left becomes a 0 column with length 0.
Eigen::VectorXd orthonormalise(Eigen::MatrixXd& columns);

}  // namespace jointid::oscillation
