#include "ident/equations/assemble.hpp"

#include <algorithm>
#include <chrono>

#include "base/stopwatch.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/result/chunk_pipeline.hpp"
#include "minimise/linear/solve_linear.hpp"

namespace jointid::ident {
namespace {

/// Assembles chunks of lines, each into a system of its own, and merges them in order.
class Assembler final : public ChunkWorker {
 public:
  /// Shares the plan's own builder, or has one of its own when others work beside it.
  Assembler(const Plan& plan, const std::vector<Line>& lines, bool alone, bool measures_rounding, Assembled& total, double& read_time)
      : plan_(plan),
        lines_(lines),
        own_builder_(alone ? nullptr : linear_plan(plan)->make_builder(plan)),
        builder_(alone ? *linear_plan(plan)->builder : *own_builder_),
        chunk_(plan.columns->size(), total.accumulator.reduction()),
        total_(total),
        read_time_(read_time) {
    product_.wants_error_scale = measures_rounding;
    for (const AssemblySpec& spec : linear_plan(plan)->specs()) assemblers_.emplace_back(spec, measures_rounding, &rounding_);
  }

  void read(std::size_t first, std::size_t last) override {
    const Clock::time_point start = Clock::now();
    substructure_lines_.clear();
    assembly_lines_.clear();
    for (std::size_t i = first; i < last; ++i) {
      substructure_lines_.push_back(lines_[i].substructures);
      assembly_lines_.push_back(lines_[i].assembly);
    }
    builder_.read(substructure_lines_, assembly_lines_);
    read_time_ += seconds_since(start);
  }

  void work(std::size_t first, std::size_t last) override {
    for (LineAssembler& each : assemblers_) each.reset_counts();
    rounding_ = {};
    unusable_ = 0;
    const bool only_chunk = first == 0 && last == lines_.size();
    minimise::Accumulator& to = only_chunk ? total_.accumulator : chunk_;
    for (std::size_t i = first; i < last; ++i) {
      product_.frequency_hz = lines_[i].frequency_hz;
      for (std::size_t k = 0; k < assemblers_.size(); ++k) {
        if (builder_.product(i - first, k, product_)) {
          assemblers_[k].add(product_, to);
        } else {
          ++unusable_;
        }
      }
    }
    to.flush();
  }

  void merge() override {
    total_.accumulator.merge(chunk_);
    chunk_.clear();
    std::size_t lines = 0;
    for (const LineAssembler& each : assemblers_) {
      total_.equations.used += each.count().used;
      total_.equations.dropped += each.count().dropped;
      total_.equations.rows += each.count().rows;
      lines = std::max(lines, each.lines_used());
    }
    total_.equations.dropped += unusable_ * plan_.cost.equations_per_line / assemblers_.size();
    total_.lines += lines;
    total_.rounding.merge(rounding_);
  }

 private:
  const Plan& plan_;
  const std::vector<Line>& lines_;
  std::unique_ptr<EquationBuilder> own_builder_;
  EquationBuilder& builder_;
  std::vector<LineAssembler> assemblers_;  ///< one for each product of a line
  RoundingScale rounding_;
  minimise::LineProduct product_;
  minimise::Accumulator chunk_;
  std::size_t unusable_ = 0;
  std::vector<std::size_t> substructure_lines_, assembly_lines_;
  Assembled& total_;
  double& read_time_;
};

}  // namespace

namespace {

/// The systems of all processes, put together in their order as chunks are: a QR of tall and skinny parts.
void put_together(const LineShares& shares, Assembled& system) {
  const EquationCount& equations = system.equations;
  std::vector<double> counts;
  for (const std::size_t count : {equations.used, equations.dropped, equations.rows, system.lines})
    counts.push_back(static_cast<double>(count));
  shares.sum(counts);
  const auto number = [&counts](std::size_t i) { return static_cast<std::size_t>(counts[i]); };
  system.equations = {.used = number(0), .dropped = number(1), .rows = number(2)};
  system.lines = number(3);
  RoundingScale rounding;
  for (const std::vector<double>& packed : shares.gathered(system.rounding.packed())) rounding.merge_packed(packed);
  system.rounding = rounding;
  minimise::Accumulator whole(system.accumulator.columns(), system.accumulator.reduction());
  for (const std::vector<double>& packed : shares.gathered(system.accumulator.packed())) whole.merge_packed(packed);
  system.accumulator = std::move(whole);
}

}  // namespace

namespace {

/// A plan that was moved has its restriction elsewhere.
void point_to(const Plan& plan) {
  LinearPlan& own = *linear_plan(plan);
  own.spec.restriction = &plan.restriction;
  for (AssemblySpec& spec : own.part_specs) spec.restriction = &plan.restriction;
}

}  // namespace

Assembled assemble(const Plan& plan, const std::vector<Line>& of, RunTime& runtime, const Control& control) {
  const Clock::time_point start = Clock::now();
  point_to(plan);
  Assembled out{minimise::Accumulator(plan.columns->size(), reduction_of(plan)), {}, 0, {}};
  const bool measures_rounding = control.detail == Detail::full;
  const std::size_t chunk = chunk_lines(linear_plan(plan)->builder->entries_per_line());
  const LineShares::Range lines = control.shares.own(of.size());
  const std::size_t count = worker_count(lines.size(), chunk, control.threads);
  double read_time = 0.0;
  std::vector<std::unique_ptr<ChunkWorker>> workers;
  for (std::size_t i = 0; i < count; ++i) {
    workers.push_back(std::make_unique<Assembler>(plan, of, count == 1, measures_rounding, out, read_time));
  }
  run_chunks(lines, chunk, "assembling", workers, control);
  if (control.shares.size() > 1) put_together(control.shares, out);
  runtime.read += read_time;
  runtime.assemble += seconds_since(start) - read_time;
  return out;
}

Assembled assemble(const Plan& plan, RunTime& runtime, const Control& control) {
  return assemble(plan, plan.lines, runtime, control);
}

minimise::Reduction reduction_of(const Plan& plan) {
  return plan.solver == Solver::normal ? minimise::Reduction::normal : minimise::Reduction::orthogonal;
}

minimise::LinearSolution solve(const Plan& plan, minimise::Accumulator& accumulator, minimise::Condition condition) {
  if (plan.solver == Solver::normal) return minimise::solve_normal(accumulator, condition);
  if (plan.solver == Solver::qr) return minimise::solve_dense(accumulator, condition);
  const auto way = plan.solver == Solver::spqr      ? minimise::SparseWay::qr
                   : plan.solver == Solver::cholmod ? minimise::SparseWay::cholmod
                                                    : minimise::SparseWay::ldlt;
  return minimise::solve_sparse(accumulator, condition, way);
}

}  // namespace jointid::ident
