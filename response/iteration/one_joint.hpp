#pragma once

#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

/// The solution of one joint and one harmonic as a root of one unknown.
struct OneJointSolution {
  bool applies = false;    ///< the equations have one joint and one harmonic n ≥ 1
  double amplitude = 0.0;  ///< |Q|, m
  int evaluations = 0;     ///< of the joint's force
  Eigen::VectorXd motion;
};

/// R4.3: with the phase turned so that Q = a > 0, b = a + GF(a), and |b| is known, so that g(a) = |a + GF(a)| = |b| is one real
/// equation. Its root always lies in [|b|/(1 + |G|k), |b| + 4|G|T∞/π], k and T∞ initial stiffness and limit of the joint; a joint
/// without a limit doubles the right end. Brent's method, so it cannot fail. For a structure that is passive (Im G ≤ 0) and a law
/// with T″ ≤ 0 the root is the only one; with a cubic spring it may be one of several.
OneJointSolution one_joint(const CondensedEquations& equations, const HarmonicLine& line, double level);

}  // namespace jointid::response
