#pragma once

#include <Eigen/Core>
#include <memory>

#include "ident/likelihood/line/way_back.hpp"

namespace jointid::ident {

/// The part of a line's least-squares problem that is left for the joint unknowns once its FRFs are eliminated (Schur
/// complement), and the way back to the FRFs.
struct ReducedLine {
  Eigen::MatrixXd information;                  ///< p×p: Σ JᵀJ − WᵀU⁻¹W; p counts systematic errors, too
  Eigen::VectorXd gradient;                     ///< p: a step of the unknowns solves information · δθ = gradient
  std::shared_ptr<const WayBack> back;          ///< U⁻¹W; shared by copies: the largest part
  LineStep own;                                 ///< 2v, U⁻¹g: the step of the FRFs is own − back · δθ
  double cost = 0.0;                            ///< χ² of the linearised problem at δθ = 0

  /// The FRFs' part of a step of the joint: −U⁻¹W δθ.
  LineStep answer(const Eigen::VectorXd& step) const { return -back->times(step); }

  /// Whether there is any information.
  bool tells() const { return information.trace() > 0.0; }

  /// χ² of the linearised problem after a step of the joint.
  double cost_after(const Eigen::VectorXd& step) const { return cost - step.dot(2.0 * gradient - information * step); }
};

/// 1/σ of an FRF that was not measured: it may be 10³ times as large as the largest of those around it.
inline double guessed_weight(const ComplexMatrix& around) {
  constexpr double wide = 1e3;
  return around.size() == 0 ? 0.0 : 1.0 / (wide * std::sqrt(around.cwiseAbs2().maxCoeff()));
}

}  // namespace jointid::ident
