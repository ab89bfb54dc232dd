#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/time/exact_march.hpp"
#include "response/time/joint_path.hpp"

namespace jointid::response {

/// What Algorithm Two may be told.
struct AlgorithmTwoOptions {
  double weight = 1.0 / 3.0;  ///< a of (3.34)
  /// k_r of every joint, N/m; empty: dT/du(0), the least that is safe.
  Eigen::VectorXd reference_stiffness = {};
  bool starts_by_algorithm_one = true;  ///< else from x(−Δ) = 0, p(−Δ) = 2p(0) − p(Δ)
  std::vector<NormalLoad> loads = {};   ///< a normal load for each joint, or none
};

/// Time marching without iteration (Ren 1992, 3.34, 3.47), explicit in the joints' forces:
/// [M/Δ² + C/2Δ + aK̃]x₂ = a p₂ + (1−2a)p₁ + a p₀ − W f₁ + K_r x₁ + [2M/Δ² − (1−2a)K̃]x₁ + [−M/Δ² + C/2Δ − aK̃]x₀,
/// K̃ = K + K_r, K_r = W k_r Wᵀ. Of order 2. With k_r below the joints' stiffness it may be unstable while they stick; slipping
/// joints then bound the motion, which looks plausible and is wrong (bounded instability). With k_r above it the error grows with
/// k_rΔ².
class AlgorithmTwo {
 public:
  /// From rest at t = 0 in steps of `delta` s. Throws InputError (check()).
  AlgorithmTwo(JointedStructure structure, ForceHistory force, double delta, const AlgorithmTwoOptions& options = {});

  void step();

  /// x and f; ẋ by the difference of the last two steps, of order 1.
  const Instant& motion() const { return motion_; }

  /// Joints with k_r < dT/du(0), which may be boundedly unstable.
  const std::vector<Eigen::Index>& too_soft() const { return too_soft_; }
  /// Spectral radius of the character matrix with every joint sticking (3.39): above 1 the motion of sticking joints grows.
  double growth() const { return growth_; }

 private:
  void advance(const Eigen::VectorXd& x);

  JointedStructure structure_;
  ForceHistory force_;
  double delta_;
  AlgorithmTwoOptions options_;
  Eigen::MatrixXd lower_, now_, before_;  ///< Cholesky factor of the left side; matrices of x₁ and x₀
  std::vector<JointPath> paths_;
  Instant motion_;
  Eigen::VectorXd last_;
  std::size_t steps_ = 0;
  std::vector<Eigen::Index> too_soft_;
  double growth_ = 0.0;
};

/// The character matrix B of Algorithm Two, (x₂, x₁) = B (x₁, x₀) of free motion with joints of tangent stiffness `tangents`
/// (3.39), 2N × 2N; a = `weight`, k_r by joint.
Eigen::MatrixXd character_matrix(const JointedStructure& structure, double delta, double weight,
                                 const Eigen::VectorXd& reference_stiffness, const Eigen::VectorXd& tangents);

/// Largest modulus of its eigenvalues.
double spectral_radius(const Eigen::MatrixXd& matrix);

}  // namespace jointid::response
