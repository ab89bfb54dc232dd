#pragma once

#include "response/joint/cubic_spring.hpp"
#include "response/time/joint_state.hpp"

namespace jointid::response {

/// A nonlinear spring: one piece without end, no memory.
class SpringState final : public JointState {
 public:
  explicit SpringState(const CubicSpring& spring) : spring_(spring) {}

  std::unique_ptr<JointState> clone() const override { return std::make_unique<SpringState>(*this); }
  friction::Response response(double q) const override { return spring_.response(q); }
  Row drift(double) const override { return Row::Zero(parameters_); }
  void begin(double, int, double) override {}
  double turn(double q, const Row&, Row&) override { return response(q).force; }
  double reach(double q, const Row&, Row&) override { return response(q).force; }
  void follow(Eigen::Index parameters) override { parameters_ = parameters; }
  Row first_slope(double q, const Row& dq, const Row&) const override { return response(q).tangent * dq; }

 private:
  CubicSpring spring_;
  Eigen::Index parameters_ = 0;
};

}  // namespace jointid::response
