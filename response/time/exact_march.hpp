#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "response/time/joint_course.hpp"

namespace jointid::response {

/// What the structure does at one time.
struct Instant {
  double time = 0.0;
  Eigen::VectorXd x, v;  ///< N
  Eigen::VectorXd f;     ///< J
};

/// The motion between two events or less: state(σ) = z(start + σ length), 0 ≤ σ ≤ 1.
struct MarchStep {
  double start = 0.0, length = 0.0;
  Eigen::Index coordinates = 0, joints = 0;
  Eigen::MatrixXd series;  ///< Taylor coefficients of z
  std::vector<Eigen::Index> curved;
  Eigen::MatrixXd curved_forces;  ///< their polynomials

  Instant motion(double sigma) const;
};

/// Steps of one call of march() beyond which it does not begin: joints or springs stiffer than any that takes part in the motion.
inline constexpr double most_steps = 1e6;

/// Steps that one call may take beyond 20 times the least: a joint that slips within what numbers can tell would take any number.
inline constexpr double spare_steps = 1e5;

struct MarchOptions {
  double longest_step = friction::infinity;  ///< s
  /// Forces of curved joints and their polynomials differ by no more at the end of a step, in parts of the force. The motion's
  /// error is far smaller, as the end of a step is of order 16.
  double mismatch = 1e-9;
};

/// Event-exact time marching (response.md §2): between events the exact flow; events (a joint turns, its force comes to a kink of
/// the law or closes a loop) are found to rounding by stepping again to them, forces are never interpolated across one.
class ExactMarch {
 public:
  /// From rest at t = 0, joints without force. Throws InputError (check()).
  ExactMarch(JointedStructure structure, ForceHistory force, MarchOptions options = {});

  /// Another state at `time`. Bilinear joints have the forces `f`, those of the others follow from their memory.
  void place(double time, const Eigen::VectorXd& x, const Eigen::VectorXd& v, const Eigen::VectorXd& f);

  /// On to `until` (s). `see` is called for every step. False where it ended before: events or steps came closer to each other than
  /// numbers can tell, were too many, or the motion ran away.
  bool march(double until, const std::function<void(const MarchStep&)>& see = {});

  Instant motion() const;
  double time() const { return time_; }
  std::size_t events() const { return events_; }
  std::size_t steps() const { return steps_; }

  const JointedStructure& structure() const { return structure_; }
  const ForceHistory& force() const { return force_; }
  JointStates& joint_states() { return states_; }
  const JointStates& joint_states() const { return states_; }

  /// Sensitivities of (x, ẋ, f), one parameter a column, go along from here; through events by saltation (response.md §7). Rows
  /// of f count for bilinear joints; those of others follow from their memory.
  void follow(const Eigen::MatrixXd& slopes);
  const Eigen::MatrixXd& slopes() const { return slopes_; }

 private:
  struct Event {
    Eigen::Index joint = -1;
    bool turns = false;
    double at = 0.0;
  };

  LinearFlow& flow();
  bool step(double limit, const std::function<void(const MarchStep&)>& see);
  bool find_length(const LinearFlow& flow, JointCourse& course, double limit, Event& event);
  Event first_event(JointCourse& course, double h) const;
  void go(LinearFlow& flow, const JointCourse& course);
  void follow_slopes(const LinearFlow& flow, const JointCourse& course, const StepMatrices& step);
  void pass(const Event& event);
  void choose_directions();

  JointedStructure structure_;
  ForceHistory force_;
  MarchOptions options_;
  JointStates states_;
  double time_ = 0.0, trial_ = friction::infinity;
  Eigen::VectorXd z_;
  Eigen::MatrixXd slopes_;
  std::map<std::vector<double>, LinearFlow> flows_;
  std::size_t events_ = 0, steps_ = 0, events_here_ = 0;
};

}  // namespace jointid::response
