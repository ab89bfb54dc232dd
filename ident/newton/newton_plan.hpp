#pragma once

#include "ident/newton/response_line.hpp"
#include "ident/plan/plan.hpp"
#include "ident/plan/rectangle.hpp"

namespace jointid::ident {

/// What method "newton" needs beside the rest of a Plan.
class NewtonPlan : public MethodPlan {
 public:
  std::unique_ptr<Rectangle> substructures, assembly;
  std::unique_ptr<Plan> start;  ///< the direct solution to start from; empty when the scene gives the start

  void read_first_line(const Plan& plan) override;

  /// Reads the first `count` lines of the plan.
  std::vector<ResponseLine> read_responses(const Plan& plan, std::size_t count);
};

/// Plans method "newton" on a plan whose scene, systems, restriction, coordinates, equations, lines and columns are there. It reads
/// all FRFs of the substructures between the coordinates used, and H_nn of the assembly. Throws InputError where there is neither a
/// start nor a direct solution.
PlannedMethod plan_responses(const Plan& plan, const StartPlanner& plan_start, std::unique_ptr<NewtonPlan> own);

}  // namespace jointid::ident
