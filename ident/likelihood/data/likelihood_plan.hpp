#pragma once

#include "ident/likelihood/data/observations.hpp"
#include "ident/likelihood/data/scaled_prior.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// What method "likelihood" needs beside the rest of a Plan.
class LikelihoodPlan : public MethodPlan {
 public:
  Dofs others;  ///< non-joint coordinates that both systems have, in either role
  LikelihoodBlocks blocks;
  std::vector<ScaledPrior> priors;
  std::unique_ptr<Observations> observations;
  std::unique_ptr<Plan> start;  ///< the linear estimate to start from; empty when the scene gives the start

  std::string not_shared(const Plan& plan) const override;

  bool carries_shared_errors() const override { return observations->has_error_sums(); }

  void read_first_line(const Plan& plan) override;
};

/// That of a plan, or nullptr for other methods.
LikelihoodPlan* likelihood_plan(const Plan& plan);

/// Plans the likelihood on a plan whose scene, systems, restriction, lines and columns are there. The equations say which
/// blocks are read, as they do for Method One; coordinates count in either role, and the assembly's joint coordinates may be
/// missing (then only H_nn is used). Throws InputError for joints that are not symmetric (reciprocity) and for data without
/// variances.
PlannedMethod plan_observations(const Plan& plan, const StartPlanner& plan_start, std::unique_ptr<LikelihoodPlan> own);

}  // namespace jointid::ident
