#pragma once

#include <Eigen/Core>
#include <array>
#include <map>
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

/// What forces of the curved joints at Gauss's points of a step of length h, those of one joint after the other, do to the
/// joints.
struct Influence {
  Eigen::MatrixXd nodes;               ///< to q of the curved joints at the same points
  std::array<Eigen::MatrixXd, 3> end;  ///< to q, q̇, q̈ of all joints at the end
};

/// The motion between events: ż = A z + B f(t), z = (x, ẋ, f, g) with the joints' forces f and the state g of the force history.
/// Joints on straight pieces are part of A (ḟ = κ Wᵀẋ), the forces of the others come in through B. Everything is a Taylor sum in
/// steps of ‖A‖h ≤ 1, the exact flow to rounding.
class LinearFlow {
 public:
  /// `stiffness`: κ of every joint, none where its piece is curved. No step is to be longer than `limit` (s).
  LinearFlow(const JointedStructure& structure, const ForceHistory& force, const std::vector<std::optional<double>>& stiffness,
             double limit);

  const Eigen::MatrixXd& a() const { return a_; }
  const Eigen::MatrixXd& b() const { return b_; }
  const std::vector<Eigen::Index>& curved() const { return curved_; }

  /// 1/‖A‖ in the energy norm or the limit, s.
  double longest_step() const { return longest_step_; }

  static constexpr int terms = 26;
  /// WᵀA^k of q = Wᵀx, J × size of z, k ≤ terms.
  const Eigen::MatrixXd& rows(int k) const { return rows_[static_cast<std::size_t>(k)]; }
  /// WᵀA^kB, J × curved joints.
  const Eigen::MatrixXd& markov(int k) const { return markov_[static_cast<std::size_t>(k)]; }

  /// Taylor coefficients of z(σh), σ ≤ 1, one a column; row c of `forces` is Σ_p forces(c, p) σ^p, the force of a curved joint.
  Eigen::MatrixXd series(const Eigen::VectorXd& z, double h, const Eigen::MatrixXd& forces) const;

  /// Remembered for the longest step and its halves; valid until the next call.
  const StepMatrices& step_matrices(double h);
  const Influence& influence(double h);
  bool remembers(double h) const;

 private:
  StepMatrices make_step_matrices(double h) const;
  Influence make_influence(double h) const;
  Eigen::MatrixXd influence_at(double h, double sigma, int derivative) const;

  Eigen::MatrixXd a_, b_;
  std::vector<Eigen::Index> curved_;
  double longest_step_ = 0.0;
  std::vector<Eigen::MatrixXd> rows_, markov_;
  std::map<double, StepMatrices> steps_;
  std::map<double, Influence> influences_;
  StepMatrices other_step_;
  Influence other_influence_;
  double other_length_ = -1.0;
};

/// Σ_k c_k σ^k of the columns of `series`.
Eigen::VectorXd sum_series(const Eigen::MatrixXd& series, double sigma);

}  // namespace jointid::response
