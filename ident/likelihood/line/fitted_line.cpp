#include "ident/likelihood/line/fitted_line.hpp"

#include <algorithm>
#include <utility>

#include "base/eigen.hpp"
#include "ident/likelihood/line/guess_y.hpp"

namespace jointid::ident {
namespace {

ReducedLine nothing(const LineLayout& layout, const FittedLine& line) {
  const auto p = at(line.columns.size()), v = at(2 * layout.variables());
  return {Eigen::MatrixXd::Zero(p, p), Eigen::VectorXd::Zero(p), Eigen::MatrixXd::Zero(v, p), LineStep::Zero(v), line.redundancy};
}

/// The implicit iteration for a given joint: from the measured FRFs of both systems to the constraint between them.
LineState approached(const LineData& data, const ComplexMatrix& z, LineModel& model, const JointImpedance& joint) {
  LineState state = first_state(model.layout(), data, z);
  for (int iteration = 0; iteration < 20; ++iteration) {
    model.linearise(data, joint, z, state, false);
    const auto reduced = model.reduce(0.0);
    if (!reduced) break;
    model.advance(reduced->own, ComplexMatrix::Zero(z.rows(), z.cols()), state);
  }
  return state;
}

}  // namespace

LineState first_state(const LineLayout& layout, const LineData& data, const ComplexMatrix& z) {
  LineState state = measured_start(layout, data);
  guess_y(layout, data, z, state);
  put_on_constraint(layout, z, state);
  for (std::size_t v = 0; v < layout.a.size(); ++v) {
    if (data.a.weight[v] != Complex(0.0)) state.a(at(layout.a[v].row), at(layout.a[v].column)) = data.a.value[v];
  }
  for (std::size_t v = 0; v < layout.b.size(); ++v) {
    if (data.b.weight[v] == Complex(0.0)) continue;
    state.b(at(layout.b[v].row), at(layout.b[v].column)) = data.b.value[v];
    state.b(at(layout.b[v].column), at(layout.b[v].row)) = data.b.value[v];
  }
  return state;
}

ReducedLine linearised(const LineData& data, const ComplexMatrix& z, LineModel& model, const FittedLine& line) {
  model.linearise(data, line.joint, z, line.state, true);
  std::optional<ReducedLine> reduced = model.reduce(0.0);
  for (double damping = 1e-3; !reduced && damping < 1e12; damping *= 10.0) reduced = model.reduce(damping);
  return reduced ? std::move(*reduced) : nothing(model.layout(), line);
}

void relax(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line, Relaxation until) {
  const LineLayout& layout = model.layout();
  put_on_constraint(layout, z, line.state);
  line.cost = line_cost(layout, data, z, line.state.x, line.state.y);
  double damping = 0.0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    model.linearise(data, line.joint, z, line.state, false);
    double gain = 0.0;
    while (damping < 1e12) {
      if (const auto reduced = model.reduce(damping)) {
        ComplexMatrix x = line.state.x, y = line.state.y;
        move(layout, reduced->own, 1.0, x, y);
        const double cost = line_cost(layout, data, z, x, y);
        if (cost <= line.cost) {
          gain = line.cost - cost;
          line.state.x = std::move(x);
          line.state.y = std::move(y);
          line.cost = cost;
          break;
        }
      }
      damping = std::max(10.0 * damping, 1e-2);
    }
    put_on_constraint(layout, z, line.state);
    damping = damping > 1e-2 ? 0.1 * damping : 0.0;
    const double enough =
        until == Relaxation::end ? 1e-7 * std::max(line.cost, 1.0) : next_to_nothing * std::max(line.cost, line.redundancy);
    if (gain <= enough) break;
  }
}

void relax_again(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line) {
  const auto relax_from = [&](LineState start) {
    const double cost = line.cost;
    const LineState kept = std::exchange(line.state, std::move(start));
    relax(data, z, model, line);
    if (line.cost < cost) return;
    line.state = kept;
    line.cost = cost;
  };
  if (!line.far_from_fitting()) return;
  LineState measured = line.state;
  take_measured(model.layout(), data, measured);
  relax_from(std::move(measured));
  if (line.far_from_fitting()) relax_from(approached(data, z, model, line.joint));
}

}  // namespace jointid::ident
