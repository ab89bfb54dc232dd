#pragma once

#include <complex>
#include <memory>
#include <random>
#include <vector>

#include "friction/law/laws.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/identify/measured_state.hpp"
#include "response/structure/matrix_receptance.hpp"

/// Measured states of three masses with joints that slip.
namespace jointid::response {

using Structure = std::shared_ptr<const Receptance>;

/// Three masses, a joint between 2 and 3 and one between 3 and ground or the first alone; all measured.
inline Structure masses(Eigen::Index joints) {
  Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), k(3, 3), w(3, 2);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 0.0, 1.0, 0.0, -1.0, 1.0;
  const Eigen::MatrixXd all = Eigen::MatrixXd::Identity(3, 3);
  return std::make_shared<MatrixReceptance>(MatrixStructure{m, 1e-3 * k, k}, w.leftCols(joints), all, all.leftCols(1));
}

/// Responses without noise, harmonics 1 and 3 measured of a model with those to 5; empty where one does not converge.
inline std::vector<MeasuredState> measure(const Structure& structure, const std::vector<Joint>& joints,
                                          const std::vector<double>& levels, const std::vector<double>& omegas) {
  std::vector<MeasuredState> states;
  for (const double level : levels) {
    for (const double omega : omegas) {
      const Excitation force = Excitation::single(std::polar(level, 0.3));
      const HarmonicSolution solution = HarmonicBalance(structure, joints, force, {.fixed = {1, 3, 5}}).solve(omega);
      if (!solution.converged) return {};
      states.push_back({omega, force, {1, 3}, solution.response.topRows(2), Eigen::MatrixXd::Constant(2, 3, 1e-4)});
    }
  }
  return states;
}

inline std::shared_ptr<const friction::Element> law(const char* name, const std::vector<double>& values) {
  return friction::make_element(name, values);
}

/// With circular noise of the states' deviations.
inline std::vector<MeasuredState> noisy(std::vector<MeasuredState> states, std::mt19937_64& generator) {
  std::normal_distribution<double> normal;
  for (MeasuredState& state : states) {
    for (Eigen::Index i = 0; i < state.response.size(); ++i) {
      const double re = normal(generator), im = normal(generator);
      state.response.data()[i] += state.deviation.data()[i] * Complex(re, im);
    }
  }
  return states;
}

}  // namespace jointid::response
