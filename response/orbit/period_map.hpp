#pragma once

#include <optional>
#include <vector>

#include "response/orbit/periodic_problem.hpp"
#include "response/time/exact_march.hpp"
#include "response/time/jenkins_state.hpp"
#include "response/time/masing_state.hpp"

namespace jointid::response {

/// One period of a problem, from state to state: s = (x, ẋ, f of the bilinear joints, memory of the others). That memory is where
/// the joint turned in the last period; its path begins without residual force at the largest |q| of them.
class PeriodMap {
 public:
  PeriodMap(const PeriodicProblem& problem, const MarchOptions& options);

  /// Another state than rest: x, ẋ, forces of all joints (those of bilinear ones count) and where each turned in the last period.
  void start(const Eigen::VectorXd& x, const Eigen::VectorXd& v, const Eigen::VectorXd& f,
             const std::vector<std::vector<double>>& turns);

  /// Derivatives from here on are those of the motion itself, whose residual forces stay where they are free: a perturbed cycle
  /// hangs inside the one before. (Until here the largest |q| lies on the virgin curve, which is no motion but a choice.)
  void keep_residual_forces() { keeps_ = true; }

  /// Marches one period from state(), with the derivative or without. False when the march stalls.
  bool run(bool with_derivative);

  const Eigen::VectorXd& state() const { return state_; }
  /// Where the period leads to, and ∂/∂s of it. The image may remember another number of turns than the state: then both are cut
  /// to what stands before the memory.
  const Eigen::VectorXd& image() const { return image_; }
  const Eigen::MatrixXd& derivative() const { return derivative_; }

  /// The state becomes the image, or moves by ds as far as the image goes.
  void accept_image();
  void move(const Eigen::VectorXd& ds);
  /// After a move into a state from which the march stalls: the image from which it went is the state.
  void abandon_move();

  /// Of every element of the image, the size of its kind: x and ẋ/ω of the largest, the limit of its joint.
  Eigen::VectorXd scales() const;
  /// Largest |image − state| of x, ẋ, f in parts of scales().
  double closure() const;

  /// Rows of s whose bilinear joint stuck all the period: image = state there, whatever the state. Not those that slipped when
  /// their residual force was taken away, as it is more than the joint can hold.
  std::vector<bool> idle_rows() const;
  /// f − kq of such a row's joint at the beginning of the period, and its derivatives by s.
  double residual_force(Eigen::Index row) const;
  Eigen::RowVectorXd residual_derivative(Eigen::Index row) const;

  /// Whether any residual force of the joint would stay.
  bool residual_force_free(Eigen::Index joint) const;
  bool bilinear(Eigen::Index joint) const;
  std::size_t events() const { return events_; }

  /// t = 0 at state(), without sensitivities.
  void place() { place(0); }
  ExactMarch& march() { return march_; }

 private:
  using Turns = std::vector<MasingState::Turn>;

  MasingState* masing(std::size_t joint) const;
  JenkinsState& jenkins(Eigen::Index row) const;
  Eigen::Index motion_size() const;
  void place(Eigen::Index columns);
  std::optional<double> tangent_of_loop(std::size_t joint) const;
  void remember_turns();
  void collect_image();

  std::vector<Eigen::Index> bilinear_;
  double omega_, period_;
  ExactMarch march_;
  Eigen::VectorXd state_, image_, state_before_, image_before_;
  Eigen::MatrixXd derivative_;
  std::vector<Turns> memory_, next_memory_, memory_before_;  ///< by joint, empty for bilinear ones
  std::vector<bool> free_;
  std::vector<bool> was_idle_, bound_to_slip_;  ///< by row of s
  std::size_t events_ = 0;
  bool keeps_ = false;
};

}  // namespace jointid::response
