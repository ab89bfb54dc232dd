#include "ident/linear/linear_method.hpp"

#include "base/stopwatch.hpp"
#include "ident/admissible/admissible_linear.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/linear/rounding_judgement.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/prediction.hpp"

namespace jointid::ident {
namespace {

std::string without_equations(const Plan& plan) {
  const bool filtered = plan.scene.identify.delta > 0.0;
  return std::string("No equation is left: the FRFs are missing or zero, or their matrices singular, on every line") +
         (filtered ? ", or delta dropped them. Lower delta" : ". Choose other lines") +
         ", or look with `jointid info` at what the files hold.";
}

void estimate(const Plan& plan, Assembled& system, const Control& control, Solution& out) {
  minimise::LinearSolution linear;
  std::vector<double> free;  // without the constraints
  bool settled = true;
  {
    const Stopwatch watch(out.runtime_s.solve);
    stop_if(control.interrupted);
    if (control.progress) control.progress("solving", 0, 0);
    linear = solve(plan, system.accumulator,
                   control.detail == Detail::full ? minimise::Condition::compute : minimise::Condition::skip);
    if (plan.admissible) free = linear.y;
    if (plan.admissible && linear.rank > 0)
      out.admissibility = constrain(plan, system.accumulator, system.equations.rows, linear, settled);
  }
  interpret(plan, linear, out);
  if (out.admissibility) {
    tell_outcome(plan, out);
  } else if (control.detail == Detail::full) {
    judge_rounding(plan, linear, system.rounding, out);
  }
  system.rounding = {};  // of many joints these are large
  system.accumulator.release();
  if (!settled) {
    out.status = Status::not_converged;
    out.message += "The constrained least-squares problem did not converge.";
  }
  tell_and_predict(plan, control, out);
  if (control.detail != Detail::full || control.judgement != Judgement::data) return;
  const Stopwatch watch(out.runtime_s.check);
  judge_linear(plan, linear, free, control, out);
  judge_unknown_noise(out);
}

/// Assembles all lines, solves and judges, which all linear methods have in common.
class LinearMethod : public LinearPlan {
 public:
  void solve(const Plan& plan, const Control& control, Solution& out) override {
    Assembled system = assemble(plan, out.runtime_s, control);
    out.fit.equations_used = system.equations.used;
    out.fit.equations_dropped = system.equations.dropped;
    out.fit.lines = system.lines;
    out.used.accumulator_bytes = system.accumulator.bytes();
    if (system.equations.used > 0) {
      estimate(plan, system, control, out);
    } else {
      out.status = Status::no_equations;
      out.message = without_equations(plan);
    }
  }
};

constexpr const char* rows_by_parts_note =
    "The assembly was not excited at its joints: Method One balances each substructure alone, with motion at all its joint coordinates. "
    "Noise of the FRFs counts 20 to 30 times more there than the data allow (docs/many-joints.md).";

class MethodOnePlan final : public LinearMethod {
 public:
  explicit MethodOnePlan(const Plan& plan) {
    if (plan.why_by_parts)
      parts = parts_of_rows(plan.coordinates, EquationSet(plan.equations), plan.restriction, *plan.substructures);
  }

  std::unique_ptr<EquationBuilder> make_builder(const Plan& plan) const override {
    if (!parts.empty())
      return make_part_rows(parts, plan.coordinates, EquationSet(plan.equations), *plan.substructures, *plan.assembly);
    return make_method_one(plan.coordinates, EquationSet(plan.equations), *plan.substructures, *plan.assembly);
  }

  /// That takes H_bb, too.
  void plan_prediction(const Plan& plan, PlannedMethod& out) const {
    const EquationSet use(plan.equations);
    const Coordinates& at = plan.coordinates;
    if (!parts.empty()) {
      out.left_out.emplace_back("forces at the joints of the assembly: the rows are those of each substructure alone");
      out.left_out.emplace_back("the assembly FRF error: it takes all joints at once");
      out.notes.emplace_back(rows_by_parts_note);
      return;
    }
    if (!use.nj && !use.jj) {
      out.left_out.push_back("the assembly FRF error: it needs H_bb, which the equations do not read");
      return;
    }
    out.predicted_responses = joined(only_if(use.nn || use.nj, at.responses), only_if(use.jj || use.jn, at.joint));
    out.predicted_references = joined(only_if(use.nn || use.jn, at.references), at.joint);
  }

  std::vector<std::string> left_out(const Plan& plan) const override {
    if (!parts.empty()) return {};
    const EquationSet use(plan.equations);
    const std::pair<bool, const char*> blocks[] = {
        {use.nn, "H_aa and H_nn"}, {use.nn || use.nj, "H_nj"}, {use.nn || use.jn, "H_ba"},
        {use.nj, "H_ab"},          {use.nj || use.jj, "H_bb"}, {use.jj || use.jn, "H_jj"},
        {use.jn, "H_jn"}};
    std::vector<std::string> out;
    for (const auto& [used, block] : blocks) {
      if (!used) out.push_back(std::string(block) + ": not read");
    }
    return out;
  }
};

class MethodTwoPlan final : public LinearMethod {
 public:
  explicit MethodTwoPlan(const Plan&) {}

  std::unique_ptr<EquationBuilder> make_builder(const Plan& plan) const override {
    return make_method_two(plan.coordinates, EquationSet(plan.equations), *plan.substructures, *plan.assembly);
  }

  std::size_t rows_of_a(const Plan& plan) const override { return plan.coordinates.joint.size(); }

  bool keeps_parts_apart() const override { return false; }

  void plan_prediction(const Plan& plan, PlannedMethod& out) const {
    const EquationSet use(plan.equations);
    const Coordinates& at = plan.coordinates;
    out.predicted_responses = joined(at.responses, at.joint);
    out.predicted_references = joined(only_if(use.jn, at.references), only_if(use.jj, at.joint));
  }
};

class DirectPlan final : public LinearMethod {
 public:
  explicit DirectPlan(const Plan&) {}

  std::unique_ptr<EquationBuilder> make_builder(const Plan& plan) const override {
    return make_direct(plan.coordinates, *plan.substructures, *plan.assembly);
  }

  void plan_prediction(const Plan& plan, PlannedMethod& out) const {
    out.predicted_responses = plan.coordinates.responses;
    out.predicted_references = plan.coordinates.references;
  }
};

template <class Method>
PlannedMethod planned(const Plan& plan) {
  auto own = std::make_unique<Method>(plan);
  PlannedMethod out = plan_linear(plan, *own);
  own->plan_prediction(plan, out);
  out.method = std::move(own);
  return out;
}

}  // namespace

PlannedMethod plan_method_one(const Plan& plan) { return planned<MethodOnePlan>(plan); }

PlannedMethod plan_method_two(const Plan& plan) { return planned<MethodTwoPlan>(plan); }

PlannedMethod plan_direct(const Plan& plan) { return planned<DirectPlan>(plan); }

}  // namespace jointid::ident
