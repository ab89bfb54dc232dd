#pragma once

#include <vector>

#include "response/orbit/periodic_orbit.hpp"
#include "response/time/jenkins_state.hpp"
#include "response/time/masing_state.hpp"

namespace jointid::response {

/// One period of a problem, from state to state: s = (x, ẋ, f of the bilinear joints); the memory of the others is kept beside it as
/// the turns of the last period from the largest |q| on, with their derivatives by s.
class PeriodMap {
 public:
  PeriodMap(const PeriodicProblem& problem, const MarchOptions& options);

  const Eigen::VectorXd& state() const { return state_; }
  /// Where a period leads to, and ∂/∂s of it.
  const Eigen::VectorXd& image() const { return image_; }
  const Eigen::MatrixXd& derivative() const { return derivative_; }

  /// Marches one period from state(). False when the march stalls.
  bool run();

  /// The state becomes the image, or moves by ds and the memory with it.
  void accept_image();
  void move(const Eigen::VectorXd& ds);

  /// Of every element of s, the size of its kind: x and ẋ/ω of the largest, the limit of its joint.
  Eigen::VectorXd scales() const;
  /// Largest |image − state| in parts of scales().
  double closure() const;

  /// Rows of s whose joint stuck all the last period: image = state there, whatever the state.
  std::vector<bool> idle_rows() const;
  /// f − kq at the beginning of the period, of the joint of such a row, and its derivatives by s.
  double residual_force(Eigen::Index row) const;
  Eigen::RowVectorXd residual_derivative(Eigen::Index row) const;

  bool residual_force_free(Eigen::Index joint) const;
  std::size_t events() const { return events_; }

  /// Eigenvalues of the monodromy matrix of s and of the open corners; a march more.
  Eigen::VectorXcd multipliers();

  /// t = 0 at state(), sensitivities by the `columns` first of which are s.
  void place(Eigen::Index columns);
  ExactMarch& march() { return march_; }

 private:
  using Turns = std::vector<MasingState::Turn>;

  MasingState* masing(std::size_t joint);
  JenkinsState& jenkins(Eigen::Index row) const;
  Eigen::VectorXd pack() const;
  Eigen::MatrixXd rows_of_state() const;
  void remember_turns();

  std::vector<Eigen::Index> bilinear_;
  double omega_, period_;
  ExactMarch march_;
  Eigen::VectorXd state_, image_;
  Eigen::MatrixXd derivative_;
  std::vector<Turns> memory_, next_memory_;  ///< by joint, empty for bilinear ones
  std::vector<bool> free_;
  std::size_t events_ = 0;
};

}  // namespace jointid::response
