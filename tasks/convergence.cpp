#include "tasks/convergence.hpp"

#include "ident/admissible/admissible_linear.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/result/chunk_pipeline.hpp"

namespace jointid::tasks {
namespace {

/// Assembles one line after the other and solves what is there in between.
class Follower final : public ident::ChunkWorker {
 public:
  Follower(const ident::Plan& plan, std::size_t points, std::vector<LineQuality>& out)
      : plan_(plan),
        builder_(*linear_plan(plan)->builder),
        points_(points),
        assembler_(linear_plan(plan)->spec),
        accumulator_(plan.columns->size(), reduction_of(plan)),
        out_(out) {}

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
      if (builder_.line(i - first, product_)) assembler_.add(product_, accumulator_);
      if (is_point(i)) judge(i);
    }
  }

  void merge() override {}

 private:
  /// True for the last line, and for `points` lines of all.
  bool is_point(std::size_t i) const {
    const std::size_t lines = plan_.lines.size();
    return lines <= points_ || (i + 1) * points_ / lines > i * points_ / lines;
  }

  void judge(std::size_t i) {
    accumulator_.flush();
    if (accumulator_.triangles().empty()) return;
    minimise::LinearSolution linear = solve(plan_, accumulator_, minimise::Condition::skip);
    bool settled = true;
    if (plan_.admissible) constrain(plan_, accumulator_, assembler_.count().rows, linear, settled);
    if (linear.rank < plan_.columns->size()) return;
    ident::Solution solution;
    interpret(plan_, linear, solution);
    out_.push_back({i + 1, plan_.lines[i].frequency_hz, solution.quality});
  }

  const ident::Plan& plan_;
  ident::EquationBuilder& builder_;
  std::size_t points_;
  ident::LineAssembler assembler_;
  minimise::Accumulator accumulator_;
  minimise::LineProduct product_;
  std::vector<LineQuality>& out_;
};

}  // namespace

std::vector<LineQuality> quality_by_line(const ident::Plan& plan, std::size_t points, const ident::Control& control) {
  std::vector<LineQuality> out;
  if (plan.scene.truth.empty() || linear_plan(plan) == nullptr) return out;
  std::vector<std::unique_ptr<ident::ChunkWorker>> workers;
  workers.push_back(std::make_unique<Follower>(plan, points, out));
  run_chunks({0, plan.lines.size()}, ident::chunk_lines(plan.entries_per_line), "following lines", workers, control);
  return out;
}

}  // namespace jointid::tasks
