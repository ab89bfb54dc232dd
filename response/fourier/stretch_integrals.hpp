#pragma once

#include <vector>

#include "response/fourier/loading_levels.hpp"
#include "response/fourier/periodic_path.hpp"

namespace jointid::response {

/// Integrals along a stretch of a Masing path, v = s(q − q_c)/2.
struct StretchIntegrals {
  Eigen::VectorXcd rotation;    ///< ∫ e^{−inθ} dθ, [harmonics of the force]
  Eigen::VectorXcd force;       ///< ∫ 2sT(v) e^{−inθ} dθ, [harmonics of the force]
  Eigen::VectorXcd tangent;     ///< ∫ T′(v) e^{−ikθ} dθ, k = 0 … sum of the largest harmonics of force and motion
  Eigen::MatrixXcd parameters;  ///< ∫ 2s∂T(v)/∂p e^{−inθ} dθ, [harmonics of the force, parameters]
};

/// Integrates an element along stretches: in closed form where T is linear, else by Gauss's rule of 20 points in pieces of at
/// most 3/(largest harmonic) rad, split at LoadingLevels; next to a corner, where T(v) may be as v^{χ+2}, with θ − θ_c as the
/// eighth power.
class StretchIntegrator {
 public:
  StretchIntegrator(const friction::Element& element, const LoadingLevels& levels, const Motion& motion, const Harmonics& force,
                    bool with_parameters);

  StretchIntegrals integrate(const PathStretch& stretch, const PathCorner& corner);

 private:
  struct Travel;
  void piece(const Travel& travel, double from, double to, bool at_corner);
  void linear_piece(const Travel& travel, double from, double to, double tangent);
  void linear_parameters(const Travel& travel, double low, double high, const Eigen::VectorXcd& moved, const Eigen::VectorXcd& turned);
  void gauss(const Travel& travel, double from, double to, bool graded);
  void add_point(const Travel& travel, double theta, double weight);
  double displacement_now() const;

  const friction::Element& element_;
  const LoadingLevels& levels_;
  const Motion& motion_;
  const Harmonics& force_;
  double longest_;  ///< piece, rad
  Eigen::Index parameters_ = 0;
  StretchIntegrals sum_;
  std::vector<Complex> powers_, ends_;
  std::vector<double> by_parameter_;
};

}  // namespace jointid::response
