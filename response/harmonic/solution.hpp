#pragma once

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "base/complex.hpp"

namespace jointid::response {

/// What the solution was reached from.
enum class Start { neighbour, stuck, free, levels, stiffness, harmonics };
std::string_view word(Start start);

/// A harmonic nω at which the structure is not known: F_n acts, what it does is only estimated.
struct DroppedHarmonic {
  int harmonic = 0;
  double force = 0.0;   ///< largest |F_n| of a joint, N
  double motion = 0.0;  ///< largest |G F_n| of a joint with G of the nearest known line, m
};

/// A periodic response x = Σ Re X_n e^{inωt} by harmonic balance. Where `converged` is false the numbers are those of the last
/// step of the last attempt, and no answer.
struct HarmonicSolution {
  bool converged = false;
  Start start = Start::stuck;
  int steps = 0;          ///< of Newton's method, all attempts
  double residual = 0.0;  ///< of the condensed equations over the sizes of their terms
  double omega = 0.0;     ///< rad/s
  double level = 1.0;     ///< factor of the forces
  std::vector<int> harmonics;
  Eigen::MatrixXcd joint_motion;  ///< Q_n, [harmonic, joint]
  Eigen::MatrixXcd joint_force;   ///< F_n, [harmonic, joint]
  Eigen::MatrixXcd response;      ///< X_n, [harmonic, response]
  Eigen::VectorXd loss;           ///< energy lost in a period, by joint, J
  double next = 0.0;              ///< largest ‖G_nF_n‖ of the next harmonics, over ‖Q‖
  std::vector<DroppedHarmonic> dropped;
};

}  // namespace jointid::response
