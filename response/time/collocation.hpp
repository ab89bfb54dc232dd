#pragma once

#include <Eigen/Core>

namespace jointid::response {

/// Gauss's points on [0, 1], with which a function on a step is a polynomial of degree points − 1.
struct Collocation {
  static constexpr int points = 8;

  Eigen::VectorXd nodes, weights;  ///< ascending; weights sum to 1
  Eigen::MatrixXd to_monomials;    ///< a = V⁻¹ f, f(σ) = Σ a_p σ^p

  /// The one that all steps share.
  static const Collocation& rule();
};

}  // namespace jointid::response
