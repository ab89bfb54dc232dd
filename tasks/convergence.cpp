#include "tasks/convergence.hpp"

#include <functional>
#include <optional>

#include "base/error.hpp"
#include "ident/admissible/admissible_linear.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/identify.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/result/chunk_pipeline.hpp"

namespace jointid::tasks {
namespace {

/// Assembles one line after the other and solves what is there in between.
class Follower final : public ident::ChunkWorker {
 public:
  using Judge = std::function<void(std::size_t line, const ident::Solution& together, const ident::Solution* alone)>;

  /// `judge` gets the solution of the lines so far, and that of the last line where it is asked for `alone` and fixes every unknown.
  Follower(const ident::Plan& plan, std::size_t points, bool alone, Judge judge)
      : plan_(plan),
        builder_(*linear_plan(plan)->builder),
        points_(points),
        assembler_(linear_plan(plan)->spec),
        line_assembler_(linear_plan(plan)->spec),
        accumulator_(plan.columns->size(), reduction_of(plan)),
        of_line_(plan.columns->size(), reduction_of(plan)),
        alone_(alone),
        judge_(std::move(judge)) {}

  void read(std::size_t first, std::size_t last) override {
    std::vector<std::size_t> substructure_lines, assembly_lines;
    for (std::size_t i = first; i < last; ++i) {
      substructure_lines.push_back(plan_.lines[i].substructures);
      assembly_lines.push_back(plan_.lines[i].assembly);
    }
    builder_.read(substructure_lines, assembly_lines);
  }

  void work(std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      product_.frequency_hz = plan_.lines[i].frequency_hz;
      const bool there = builder_.line(i - first, product_);
      if (there) assembler_.add(product_, accumulator_);
      if (!is_point(i)) continue;
      of_line_.clear();
      if (there && alone_) line_assembler_.add(product_, of_line_);
      judge(i);
    }
  }

  void merge() override {}

 private:
  /// True for the last line, and for `points` lines of all.
  bool is_point(std::size_t i) const {
    const std::size_t lines = plan_.lines.size();
    return lines <= points_ || (i + 1) * points_ / lines > i * points_ / lines;
  }

  /// Nothing where the rows do not fix every unknown.
  std::optional<ident::Solution> solved(minimise::Accumulator& rows, const ident::LineAssembler& assembler) const {
    rows.flush();
    if (rows.triangles().empty()) return std::nullopt;
    minimise::LinearSolution linear = solve(plan_, rows, minimise::Condition::skip);
    bool settled = true;
    if (plan_.admissible) constrain(plan_, rows, assembler.count().rows, linear, settled);
    if (linear.rank < plan_.columns->size()) return std::nullopt;
    ident::Solution solution;
    interpret(plan_, linear, solution);
    return solution;
  }

  void judge(std::size_t i) {
    const std::optional<ident::Solution> together = solved(accumulator_, assembler_);
    if (!together) return;
    const std::optional<ident::Solution> alone = alone_ ? solved(of_line_, line_assembler_) : std::nullopt;
    judge_(i, *together, alone ? &*alone : nullptr);
  }

  const ident::Plan& plan_;
  ident::EquationBuilder& builder_;
  std::size_t points_;
  ident::LineAssembler assembler_, line_assembler_;
  minimise::Accumulator accumulator_, of_line_;
  bool alone_;
  minimise::LineProduct product_;
  Judge judge_;
};

void follow(const ident::Plan& plan, std::unique_ptr<ident::ChunkWorker> follower, const ident::Control& control) {
  std::vector<std::unique_ptr<ident::ChunkWorker>> workers;
  workers.push_back(std::move(follower));
  run_chunks({0, plan.lines.size()}, ident::chunk_lines(plan.entries_per_line), "following lines", workers, control);
}

std::vector<double> values_of(const ident::Solution& solution) {
  std::vector<double> values;
  for (const auto& unknown : solution.unknowns) values.push_back(unknown.value);
  return values;
}

}  // namespace

std::vector<LineQuality> quality_by_line(const ident::Plan& plan, std::size_t points, const ident::Control& control) {
  std::vector<LineQuality> out;
  if (plan.scene.truth.empty() || linear_plan(plan) == nullptr) return out;
  follow(plan,
         std::make_unique<Follower>(plan, points, false,
                                    [&](std::size_t i, const ident::Solution& together, const ident::Solution*) {
                                      out.push_back({i + 1, plan.lines[i].frequency_hz, together.quality});
                                    }),
         control);
  return out;
}

UnknownsByLine unknowns_by_line(const ident::Plan& plan, std::size_t points, const ident::Control& control) {
  if (linear_plan(plan) == nullptr) {
    throw InputError({ErrorKind::usage, "", "--by-line",
                      "method \"" + ident::name(plan.scene.identify.method) + "\" does not accumulate lines",
                      "follow the lines with method = \"one\", \"two\" or \"direct\""});
  }
  UnknownsByLine out;
  const auto judge = [&](std::size_t i, const ident::Solution& together, const ident::Solution* alone) {
    if (out.names.empty()) {
      for (const auto& unknown : together.unknowns) out.names.push_back(unknown.name);
    }
    out.lines.push_back({i + 1, plan.lines[i].frequency_hz, values_of(together), alone ? values_of(*alone) : std::vector<double>()});
  };
  follow(plan, std::make_unique<Follower>(plan, points, true, judge), control);
  return out;
}

UnknownsByIteration unknowns_by_iteration(ident::Plan& plan, const ident::Control& control) {
  if (linear_plan(plan) != nullptr) {
    throw InputError({ErrorKind::usage, "", "--by-iteration",
                      "method \"" + ident::name(plan.scene.identify.method) + "\" does not iterate",
                      "follow its lines by --by-line, or take method = \"likelihood\" or \"newton\""});
  }
  IterationLog log;
  ident::Control watched = control;
  watched.detail = ident::Detail::estimates;
  watched.judgement = ident::Judgement::none;
  watched.so_far = [&](const ident::Solution& best) { log.note(best); };
  return log.ended(ident::solve(plan, watched));
}

void IterationLog::note(const ident::Solution& best) {
  const std::size_t last = steps_.empty() ? 0 : steps_.back().iteration;
  if (best.status != ident::Status::not_converged || best.fit.iterations <= last) return;  // the end is the solution's
  steps_.push_back({best.fit.iterations, best.fit.objective, values_of(best)});
}

UnknownsByIteration IterationLog::ended(const ident::Solution& solution) const {
  UnknownsByIteration out;
  for (const auto& unknown : solution.unknowns) out.names.push_back(unknown.name);
  if (steps_.empty()) return out;
  out.iterations = steps_;
  IterationUnknowns end = steps_.back();
  ++end.iteration;
  end.objective.reset();
  end.values = values_of(solution);
  if (end.values != steps_.back().values) out.iterations.push_back(std::move(end));
  return out;
}

}  // namespace jointid::tasks
