#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"

namespace jointid::ident {

struct Control;
struct Plan;
struct Solution;

/// One method of identification with what it needs beside the rest of a Plan, whose part it is. To add one: a folder with a class
/// of its own and a row in all_methods() (ident/methods.cpp).
class MethodPlan {
 public:
  virtual ~MethodPlan() = default;

  /// Reads what the plan reads of its first line.
  virtual void read_first_line(const Plan& plan) = 0;

  /// Reads, estimates and judges: fills unknowns, matrices, figures of merit and status of `out`, which names what is used
  /// already.
  virtual void solve(const Plan& plan, const Control& control, Solution& out) = 0;

  /// What of its data the scene does not need, one phrase each.
  virtual std::vector<std::string> left_out(const Plan&) const { return {}; }

  /// Whether it knows what errors FRFs of parts that were coupled before have in common.
  virtual bool carries_shared_errors() const { return false; }

  /// Why several processes cannot share the lines of a solution (Control::shares); empty where they can.
  virtual std::string not_shared(const Plan&) const { return "the method works on all lines at once"; }
};

}  // namespace jointid::ident
