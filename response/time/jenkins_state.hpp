#pragma once

#include "friction/law/bilinear.hpp"
#include "response/time/joint_state.hpp"

namespace jointid::response {

/// Bilinear joint: its force is all that it remembers. It sticks while |f| < L, and slips in one direction until it turns.
class JenkinsState final : public JointState {
 public:
  explicit JenkinsState(const friction::Bilinear& law);

  std::unique_ptr<JointState> clone() const override { return std::make_unique<JenkinsState>(*this); }
  friction::Response response(double q) const override;
  Row drift(double) const override { return Row::Zero(parameters_); }
  void begin(double q, int direction, double force) override;
  double turn(double q, const Row& dq, Row& df) override;
  double reach(double q, const Row& dq, Row& df) override;
  void follow(Eigen::Index parameters) override { parameters_ = parameters; }
  Row first_slope(double, const Row&, const Row& given) const override { return given; }

  bool slips() const { return piece_.direction != 0; }
  /// Whether it slipped since watch().
  bool slipped() const { return slipped_; }
  void watch() { slipped_ = slips(); }

  double stiffness() const { return stiffness_; }
  double limit() const { return limit_; }

 private:
  void stick(double q, double force);
  void slip(int direction);

  double stiffness_, limit_;
  double from_ = 0.0, force_ = 0.0;  ///< where the piece began
  bool slipped_ = false;
  Eigen::Index parameters_ = 0;
};

}  // namespace jointid::response
