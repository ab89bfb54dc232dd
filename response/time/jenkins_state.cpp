#include "response/time/jenkins_state.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {

JenkinsState::JenkinsState(const friction::Bilinear& law) : stiffness_(law.response(0.0).tangent), limit_(law.limit()) {
  stick(0.0, 0.0);
}

void JenkinsState::stick(double q, double force) {
  from_ = q;
  force_ = std::clamp(force, -limit_, limit_);
  piece_ = {0, q - (limit_ + force_) / stiffness_, q + (limit_ - force_) / stiffness_, stiffness_};
}

void JenkinsState::slip(int direction) {
  force_ = direction * limit_;
  slipped_ = true;
  piece_ = {direction, -friction::infinity, friction::infinity, 0.0};
}

friction::Response JenkinsState::response(double q) const {
  if (slips()) return {force_, 0.0};
  return {force_ + stiffness_ * (q - from_), stiffness_};
}

/// A force at its limit up to rounding slips when the motion drives it on.
void JenkinsState::begin(double q, int direction, double force) {
  if (direction * force >= (1.0 - 1e-12) * limit_) {
    slip(direction);
  } else {
    stick(q, force);
  }
}

double JenkinsState::turn(double q, const Row&, Row&) {
  stick(q, force_);
  return force_;
}

/// The slider forgets: S = I − e_f e_fᵀ.
double JenkinsState::reach(double q, const Row&, Row& df) {
  slip(2.0 * q > piece_.lower + piece_.upper ? 1 : -1);
  df.setZero();
  return force_;
}

}  // namespace jointid::response
