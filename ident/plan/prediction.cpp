#include "ident/plan/prediction.hpp"

#include <array>
#include <cmath>

#include "base/stopwatch.hpp"
#include "ident/plan/joint_effect.hpp"
#include "ident/plan/rectangle.hpp"
#include "ident/result/chunk_pipeline.hpp"

namespace jointid::ident {
namespace {

/// Predicts chunks of lines and adds their errors up in order.
class Predictor final : public ChunkWorker {
 public:
  Predictor(const Plan& plan, const std::vector<BandMatrices>& bands, DecibelError& total)
      : plan_(plan),
        bands_(bands),
        total_(total),
        substructures_(whole_rectangle(*plan.substructures,
                                       with_joint(plan.predicted_responses, plan.coordinates.joint),
                                       with_joint(plan.predicted_references, plan.coordinates.joint))),
        assembly_(whole_rectangle(*plan.assembly, plan.predicted_responses, plan.predicted_references)) {}

  void read(std::size_t first, std::size_t last) override {
    std::vector<std::size_t> substructure_lines, assembly_lines;
    for (std::size_t i = first; i < last; ++i) {
      substructure_lines.push_back(plan_.lines[i].substructures);
      assembly_lines.push_back(plan_.lines[i].assembly);
    }
    substructures_.read(substructure_lines);
    assembly_.read(assembly_lines);
  }

  void work(std::size_t first, std::size_t last) override {
    error_ = {};
    for (std::size_t i = first; i < last; ++i) {
      const double frequency = plan_.lines[i].frequency_hz;
      const Matrices* matrices = matrices_at(bands_, frequency);
      if (matrices != nullptr) add(*matrices, frequency, substructures_.line(i - first), assembly_.line(i - first));
    }
  }

  void merge() override {
    total_.sum_of_squares += error_.sum_of_squares;
    total_.entries += error_.entries;
  }

 private:
  void add(const Matrices& matrices, double frequency_hz, const minimise::View& h, const minimise::View& measured) {
    const std::size_t n = plan_.coordinates.joint.size();
    const std::size_t rows = measured.rows, columns = measured.columns;
    const JointEffect effect = joint_effect(h, rows, columns, joint_impedance(matrices, n, frequency_hz));
    const auto right = map(effect.right);
    const RowMatrixXd left_re = effect.left.real(), left_im = effect.left.imag();
    RowMatrixXd right_re = RowMatrixXd::Zero(right.rows(), static_cast<Eigen::Index>(padded(columns))), right_im = right_re;
    right_re.leftCols(right.cols()) = right.real();
    right_im.leftCols(right.cols()) = right.imag();
    add_decibel_error(h.block(0, 0, rows, columns), left_re.data(), left_im.data(), right_re.data(), right_im.data(), n,
                      measured, error_);
  }

  const Plan& plan_;
  const std::vector<BandMatrices>& bands_;
  DecibelError& total_;
  DecibelError error_;
  Rectangle substructures_, assembly_;
};

}  // namespace

DecibelError predict(const Plan& plan, const std::vector<BandMatrices>& bands, const Control& control) {
  DecibelError total;
  const std::size_t chunk = chunk_lines(plan.entries_per_line);
  std::vector<std::unique_ptr<ChunkWorker>> workers;
  const LineShares::Range lines = control.shares.own(plan.lines.size());
  for (std::size_t i = worker_count(lines.size(), chunk, control.threads); i-- > 0;) {
    workers.push_back(std::make_unique<Predictor>(plan, bands, total));
  }
  run_chunks(lines, chunk, "predicting", workers, control);
  std::array sums = {total.sum_of_squares, static_cast<double>(total.entries)};
  control.shares.sum(sums);
  return {sums[0], static_cast<std::size_t>(sums[1])};
}

namespace {

std::optional<double> assembly_error(const Plan& plan, const Solution& solution, const Control& control) {
  if (plan.predicted_responses.empty()) return std::nullopt;
  const DecibelError error = predict(plan, solution.bands, control);
  if (error.entries == 0) return std::nullopt;
  return std::sqrt(error.sum_of_squares / static_cast<double>(error.entries));
}

}  // namespace

void tell_and_predict(const Plan& plan, const Control& control, Solution& out) {
  if (control.so_far) control.so_far(out);
  if (control.detail != Detail::full) return;
  const Stopwatch watch(out.runtime_s.regenerate);
  out.fit.asm_frf_error = assembly_error(plan, out, control);
}

}  // namespace jointid::ident
