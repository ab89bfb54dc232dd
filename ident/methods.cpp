#include "ident/likelihood/likelihood.hpp"
#include "ident/linear/linear_method.hpp"
#include "ident/newton/newton.hpp"
#include "ident/plan/planned_method.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::ident {
namespace {

const std::vector<Solver> linear_solvers = {Solver::qr, Solver::normal, Solver::spqr, Solver::cholmod, Solver::ldlt};

/// What plans a linear method.
template <PlannedMethod (*plan_linear)(const Plan&)>
PlannedMethod without_start(const Plan& plan, const StartPlanner&) {
  return plan_linear(plan);
}

}  // namespace

const std::vector<MethodTraits>& all_methods() {
  static const std::vector<MethodTraits> all = {
      {.method = Method::one,
       .name = "one",
       .solvers = linear_solvers,
       .phrase = "Method One",
       .plan = without_start<plan_method_one>},
      {.method = Method::two,
       .name = "two",
       .solvers = linear_solvers,
       .phrase = "Method Two",
       .plan = without_start<plan_method_two>,
       .inverts_substructures = true},
      {.method = Method::direct,
       .name = "direct",
       .solvers = linear_solvers,
       .phrase = "the direct solution",
       .plan = without_start<plan_direct>,
       .joint_on_assembly = false,
       .inverts_references = true},
      {.method = Method::newton,
       .name = "newton",
       .solvers = {Solver::levenberg_marquardt, Solver::newton, Solver::ceres, Solver::ipopt, Solver::pattern},
       .phrase = "method \"newton\"",
       .plan = plan_newton,
       .iterates = true,
       .joint_on_assembly = false},
      {.method = Method::likelihood,
       .name = "likelihood",
       .solvers = {Solver::gauss_helmert, Solver::iqml, Solver::ceres, Solver::by_parts},
       .phrase = "method \"likelihood\"",
       .plan = plan_likelihood,
       .iterates = true,
       .uses_variances = true},
  };
  return all;
}

}  // namespace jointid::ident
