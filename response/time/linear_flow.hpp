#pragma once

#include <Eigen/Core>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "response/time/force_history.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// dz over a step of length h while no joint changes its piece: z(h) = E z + R f, f the forces of the nonlinear joints at Gauss's
/// points (those of one joint after the other).
struct StepMatrices {
  Eigen::MatrixXd transition;  ///< E = e^{Ah}
  Eigen::MatrixXd input;       ///< R
};

/// The motion between events: ż = A z + B f(t), z = (x, ẋ, f, g) with the joints' forces f and the state g of the force history.
/// Joints on straight pieces are part of A (ḟ = κ Wᵀẋ), the forces of the others come in through B. Everything is a Taylor sum in
/// steps of ‖A‖h ≤ 1, the exact flow to rounding.
class LinearFlow {
 public:
  /// `stiffness`: κ of every joint, none where its piece is curved.
  LinearFlow(const JointedStructure& structure, const ForceHistory& force, const std::vector<std::optional<double>>& stiffness);

  const Eigen::MatrixXd& a() const { return a_; }
  const Eigen::MatrixXd& b() const { return b_; }
  const std::vector<Eigen::Index>& curved() const { return curved_; }

  /// 1/‖A‖ in the energy norm, s.
  double longest_step() const { return longest_step_; }

  static constexpr int terms = 26;
  /// WᵀA^k of q = Wᵀx, J × size of z, k ≤ terms.
  const Eigen::MatrixXd& rows(int k) const { return rows_[static_cast<std::size_t>(k)]; }
  /// WᵀA^kB, J × curved joints.
  const Eigen::MatrixXd& markov(int k) const { return markov_[static_cast<std::size_t>(k)]; }

  /// Taylor coefficients of z(σh), σ ≤ 1, one a column; row c of `forces` is Σ_p forces(c, p) σ^p, the force of a curved joint.
  Eigen::MatrixXd series(const Eigen::VectorXd& z, double h, const Eigen::MatrixXd& forces) const;

  StepMatrices step_matrices(double h) const;

 private:
  Eigen::MatrixXd a_, b_;
  std::vector<Eigen::Index> curved_;
  double longest_step_ = 0.0;
  std::vector<Eigen::MatrixXd> rows_, markov_;
};

/// Σ_k c_k σ^k of the columns of `series`.
Eigen::VectorXd sum_series(const Eigen::MatrixXd& series, double sigma);

}  // namespace jointid::response
