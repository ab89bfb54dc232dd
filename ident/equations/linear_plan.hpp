#pragma once

#include "ident/equations/equation_builder.hpp"
#include "ident/equations/line_assembler.hpp"
#include "ident/equations/part_rows.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// What the methods whose equations are linear in the unknowns, A Z_j B = C₁ − C₂, need beside the rest of a Plan.
class LinearPlan : public MethodPlan {
 public:
  std::unique_ptr<EquationBuilder> builder;
  AssemblySpec spec;
  std::vector<PartOfRows> parts;         ///< of rows by parts (Plan::why_by_parts); else empty
  std::vector<AssemblySpec> part_specs;  ///< one for each of them

  std::span<const AssemblySpec> specs() const { return part_specs.empty() ? std::span(&spec, 1) : std::span(part_specs); }

  /// A further builder for the plan's equations, for a thread of its own. Reading stays one at a time: the systems are shared.
  virtual std::unique_ptr<EquationBuilder> make_builder(const Plan& plan) const = 0;

  /// Rows of A.
  virtual std::size_t rows_of_a(const Plan& plan) const;

  /// Whether a column of B has zeros at the joint DOFs of other substructures than its own.
  virtual bool keeps_parts_apart() const { return true; }

  std::string not_shared(const Plan&) const override { return {}; }

  void read_first_line(const Plan& plan) override;
};

/// That of a plan, or nullptr for other methods.
LinearPlan* linear_plan(const Plan& plan);

/// Makes the builder of `own` and plans assembly, solver and cost of the plan that it will belong to.
PlannedMethod plan_linear(const Plan& plan, LinearPlan& own);

}  // namespace jointid::ident
