#include "ident/likelihood/model/fitted_line.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/eigen.hpp"
#include "base/stop_scope.hpp"
#include "ident/likelihood/model/guess_y.hpp"
#include "ident/likelihood/model/line_gradient.hpp"

namespace jointid::ident {
namespace {

ReducedLine nothing(const LineLayout& layout, const FittedLine& line) {
  const auto p = at(line.columns.size()), v = at(2 * layout.variables());
  return {Eigen::MatrixXd::Zero(p, p), Eigen::VectorXd::Zero(p), std::make_shared<WayBack>(Eigen::MatrixXd::Zero(v, p)),
          LineStep::Zero(v), line.redundancy};
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

/// What another step of a line's FRFs would have to bring to be worth it.
double enough(const FittedLine& line, Relaxation until) {
  return until == Relaxation::end ? 1e-7 * std::max(line.cost, 1.0) : next_to_nothing * std::max(line.cost, line.redundancy);
}

/// Takes a step of the FRFs if χ² does not rise by it, and puts the line on the constraint. By how much χ² fell.
std::optional<double> take(const LineData& data, const ComplexMatrix& z, const LineLayout& layout, const LineStep& step,
                           FittedLine& line) {
  LineState moved{line.state.sub_jn, line.state.sub_jj, {}, {}};
  move(layout, step, 1.0, moved.sub_jn, moved.sub_jj);
  const double cost = cost_on_constraint(layout, data, z, moved);
  if (!(cost <= line.cost)) return std::nullopt;
  line.state = std::move(moved);
  return std::exchange(line.cost, cost) - cost;
}

/// Steps by the factors that the model has, each with the gradient where it stands, after one that brought `gain`. True when another
/// would bring next to nothing; false where the line is not near enough to the place that the factors are of: where a gain is more than
/// `shrinks` of the last one.
bool follow_gradient(const LineData& data, const ComplexMatrix& z, const LineModel& model, FittedLine& line, Relaxation until,
                     double gain, double shrinks = 0.1) {
  if (!has_plain_errors(data)) return false;
  while (gain > enough(line, until)) {
    const LineGradient gradient = gradient_of(model.layout(), data, line.joint, z, line.state);
    const LineStep step = model.own_step(gradient.own);
    const double promised = gradient.own.dot(step);
    if (promised <= enough(line, until)) return true;
    if (promised > shrinks * gain) return false;
    const auto gained = take(data, z, model.layout(), step, line);
    if (!gained) return false;
    gain = *gained;
  }
  return true;
}

/// The gradient with the FRFs optimised, by steps of the model's factors; empty where these do not get there.
std::optional<Eigen::VectorXd> followed_gradient(const LineData& data, const ComplexMatrix& z, const LineModel& model, FittedLine& line) {
  constexpr double shrinks = 0.1, negligible = 1e-9;
  double last = std::numeric_limits<double>::infinity(), cost = last;
  for (;;) {
    put_on_constraint(model.layout(), z, line.state);
    const LineGradient gradient = gradient_of(model.layout(), data, line.joint, z, line.state);
    const LineStep step = model.own_step(gradient.own);
    const double promised = gradient.own.dot(step);
    if (!(gradient.cost <= cost)) return std::nullopt;
    if (promised <= negligible * std::max(gradient.cost, 1.0)) return gradient.joint - line.reduced.back->transpose_times(gradient.own);
    if (!(promised <= shrinks * last)) return std::nullopt;
    last = promised;
    cost = gradient.cost;
    move(model.layout(), step, 1.0, line.state.sub_jn, line.state.sub_jj);
  }
}

}  // namespace

LineState first_state(const LineLayout& layout, const LineData& data, const ComplexMatrix& z) {
  LineState state = measured_start(layout, data);
  guess_y(layout, data, z, state);
  put_on_constraint(layout, z, state);
  for (std::size_t v = 0; v < layout.asm_jn.size(); ++v) {
    if (data.asm_jn.weight[v] != Complex(0.0))
      state.asm_jn(at(layout.asm_jn[v].row), at(layout.asm_jn[v].column)) = data.asm_jn.value[v];
  }
  for (std::size_t v = 0; v < layout.asm_jj.size(); ++v) {
    if (data.asm_jj.weight[v] == Complex(0.0)) continue;
    state.asm_jj(at(layout.asm_jj[v].row), at(layout.asm_jj[v].column)) = data.asm_jj.value[v];
    state.asm_jj(at(layout.asm_jj[v].column), at(layout.asm_jj[v].row)) = data.asm_jj.value[v];
  }
  return state;
}

ReducedLine linearised(const LineData& data, const ComplexMatrix& z, LineModel& model, const FittedLine& line, bool with_joint) {
  stop_point();
  model.linearise(data, line.joint, z, line.state, with_joint);
  std::optional<ReducedLine> reduced = model.reduce(0.0);
  for (double damping = 1e-3; !reduced && damping < 1e12; damping *= 10.0) reduced = model.reduce(damping);
  return reduced ? std::move(*reduced) : nothing(model.layout(), line);
}

void take_gradient(const LineData& data, const ComplexMatrix& z, const LineLayout& layout, FittedLine& line) {
  const LineGradient gradient = gradient_of(layout, data, line.joint, z, line.state);
  line.reduced.gradient = gradient.joint - line.reduced.back->transpose_times(gradient.own);
  line.reduced.own.setZero();
  line.cost = line.reduced.cost = gradient.cost;
}

Eigen::MatrixXd gradients_nearby(const LineData& data, const ComplexMatrix& here, LineModel& model, const FittedLine& line,
                                 const std::vector<JointNearby>& joints, bool has_factors) {
  Eigen::MatrixXd out(at(line.columns.size()), at(joints.size()));
  FittedLine moved = line;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    moved.state = line.state;
    move(model.layout(), line.reduced.answer(joints[k].offset), 1.0, moved.state.sub_jn, moved.state.sub_jj);
    if (!has_factors) {
      model.linearise(data, line.joint, here, line.state, false);
      has_factors = model.reduce(0.0).has_value();
    }
    if (has_factors) {
      const LineState answered = moved.state;
      if (const auto gradient = followed_gradient(data, joints[k].z, model, moved)) {
        out.col(at(k)) = *gradient;
        continue;
      }
      moved.state = answered;
    }
    relax(data, joints[k].z, model, moved);
    take_gradient(data, joints[k].z, model.layout(), moved);
    out.col(at(k)) = moved.reduced.gradient;
    has_factors = false;
  }
  return out;
}

bool settle(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line, Relaxation until) {
  const LineLayout& layout = model.layout();
  const double near = layout.is_large() ? 1e-2 : 1e-4;  // of the redundancy: as far the information is that of the place before
  line.cost = cost_on_constraint(layout, data, z, line.state);
  line.reduced = linearised(data, z, model, line);
  if (until == Relaxation::beginning && line.is_as_predicted(line.cost, line.reduced.cost)) return false;
  const double before = line.cost;
  const auto gain = take(data, z, layout, line.reduced.own, line);
  if (gain && follow_gradient(data, z, model, line, until, *gain)) {
    if (has_plain_errors(data) && (until == Relaxation::beginning || before - line.cost <= near * line.redundancy)) {
      take_gradient(data, z, layout, line);
      return true;
    }
  } else {
    relax(data, z, model, line, until);
  }
  line.reduced = linearised(data, z, model, line);
  return true;
}

void settle_measured(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line) {
  constexpr double any = std::numeric_limits<double>::infinity(), shrinks = 0.5;  // a step by a gradient costs a fifth of factors
  line.reduced = linearised(data, z, model, line);
  if (has_plain_errors(data)) {
    model.advance(line.reduced.own, ComplexMatrix::Zero(z.rows(), z.cols()), line.state);
    line.cost = cost_on_constraint(model.layout(), data, z, line.state);
    if (follow_gradient(data, z, model, line, Relaxation::end, any, shrinks)) {
      take_gradient(data, z, model.layout(), line);
      return;
    }
  }
  settle(data, z, model, line, Relaxation::beginning);
}

/// The loop is not `minimise::gauss_newton`, which asks for residuals and a Jacobian: a line has up to thousands of FRFs, and its model
/// eliminates and damps them block by block (LineModel::reduce()) without either; and a factorisation goes on to be used for steps by
/// gradients alone (follow_gradient()).
void relax(const LineData& data, const ComplexMatrix& z, LineModel& model, FittedLine& line, Relaxation until) {
  const LineLayout& layout = model.layout();
  line.cost = cost_on_constraint(layout, data, z, line.state);
  double damping = 0.0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    model.linearise(data, line.joint, z, line.state, false);
    double gain = 0.0;
    while (damping < 1e12) {
      stop_point();
      if (const auto reduced = model.reduce(damping)) {
        if (const auto gained = take(data, z, layout, reduced->own, line)) {
          gain = *gained;
          break;
        }
      }
      damping = std::max(10.0 * damping, 1e-2);
    }
    if (gain <= enough(line, until)) break;
    if (damping == 0.0 && follow_gradient(data, z, model, line, until, gain)) break;
    damping = damping > 1e-2 ? 0.1 * damping : 0.0;
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
