#pragma once

#include <limits>

#include "base/stopwatch.hpp"
#include "ident/likelihood/data/observations.hpp"
#include "ident/likelihood/fit/likelihood_fit.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Complex equations of the lines that have a say; of all where there are no weights.
std::size_t equations_used(const Observations& observations, const std::vector<double>& line_weight);

/// Tells Control::so_far the best joint so far: that of the least Σ L, before there is one the last; under the constraints of the
/// scene, as the result will be.
class BestJoint {
 public:
  BestJoint(const Plan& plan, const Solution& begun, const Control& control) : plan_(plan), begun_(begun), control_(control) {}

  void tell(const LikelihoodFit& fit, double loss);

 private:
  const Plan& plan_;
  const Solution& begun_;
  const Control& control_;
  Clock::time_point begin_ = Clock::now();
  double least_ = std::numeric_limits<double>::infinity();
  std::size_t steps_ = 0;
};

}  // namespace jointid::ident
