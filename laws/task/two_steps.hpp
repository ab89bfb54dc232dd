#pragma once

#include <string>
#include <vector>

#include "response/identify/direct_step.hpp"

namespace jointid::laws {

/// What the thesis's two steps find of a joint; NaN where they have no answer.
struct TwoSteps {
  double stiffness = 0.0;  ///< initial, N/m
  double limit = 0.0;      ///< of friction, N
};

/// Chapter 7.3: the equivalent stiffness and damping k_e + i d_e = F₁/Q₁ of every state over |Q₁|, as they are, then the law of
/// each joint fitted to that curve by (7.20). Throws InputError for a law that there is not.
std::vector<TwoSteps> two_steps(const std::vector<response::DirectStep>& steps, const std::vector<std::string>& laws);

}  // namespace jointid::laws
