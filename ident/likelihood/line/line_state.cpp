#include "ident/likelihood/line/line_state.hpp"

#include "base/eigen.hpp"
#include "base/kernel.hpp"
#include "coupling/joint_loop.hpp"
#include "ident/likelihood/line/lane_matrix.hpp"

namespace jointid::ident {
namespace {

/// A residual over its error, real and imaginary part; 0 where not measured.
Complex weighted(const Channel& channel, std::size_t i, const Complex& predicted) {
  const Complex residual = channel.value[i] - predicted, weight = channel.weight[i];
  return {weight.real() == 0.0 ? 0.0 : residual.real() * weight.real(), weight.imag() == 0.0 ? 0.0 : residual.imag() * weight.imag()};
}

double square(const Channel& channel, std::size_t i, const Complex& predicted) {
  const Complex residual = channel.value[i] - predicted, weight = channel.weight[i];
  const double re = weight.real() == 0.0 ? 0.0 : residual.real() * weight.real();
  const double im = weight.imag() == 0.0 ? 0.0 : residual.imag() * weight.imag();
  return re * re + im * im;
}

double block_cost(const std::vector<Element>& elements, const Channel& channel, const ComplexMatrix& predicted) {
  double sum = 0.0;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    sum += square(channel, i, predicted(at(elements[i].row), at(elements[i].column)));
  }
  return sum;
}

/// χ² of a line whose errors depend on each other: the sum of squares of the whitened residuals.
double correlated_cost(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, const LineState& state) {
  std::vector<Complex> errors;
  const auto append = [&](const std::vector<Element>& elements, const Channel& channel, const ComplexMatrix& predicted) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      errors.push_back(weighted(channel, i, predicted(at(elements[i].row), at(elements[i].column))));
    }
  };
  append(layout.sub_jn, data.sub_jn, state.sub_jn);
  append(layout.sub_jj, data.sub_jj, state.sub_jj);
  append(layout.asm_jn, data.asm_jn, state.asm_jn);
  append(layout.asm_jj, data.asm_jj, state.asm_jj);
  const ComplexMatrix za = z * state.asm_jn;
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i)
    errors.push_back(weighted(data.drop_nn, i, predicted_difference(state, za, layout.drop_nn[i])));
  data.correlation->whiten(errors);
  double cost = 0.0;
  for (const Complex& error : errors) cost += std::norm(error);
  return cost;
}

}  // namespace

void move(const LineLayout& layout, const LineStep& step, double scale, ComplexMatrix& x, ComplexMatrix& y) {
  Eigen::Index v = 0;
  const auto next = [&] {
    const Complex change(step[v], step[v + 1]);
    v += 2;
    return scale * change;
  };
  for (const Element& e : layout.sub_jn) x(at(e.row), at(e.column)) += next();
  for (const Element& e : layout.sub_jj) {
    const Complex change = next();
    y(at(e.row), at(e.column)) += change;
    if (e.row != e.column) y(at(e.column), at(e.row)) += change;
  }
}

void take_measured(const LineLayout& layout, const LineData& data, LineState& state) {
  for (std::size_t v = 0; v < layout.sub_jn.size(); ++v) {
    if (data.sub_jn.weight[v] != Complex(0.0))
      state.sub_jn(at(layout.sub_jn[v].row), at(layout.sub_jn[v].column)) = data.sub_jn.value[v];
  }
  for (std::size_t v = 0; v < layout.sub_jj.size(); ++v) {
    if (data.sub_jj.weight[v] == Complex(0.0)) continue;
    const auto p = at(layout.sub_jj[v].row), q = at(layout.sub_jj[v].column);
    state.sub_jj(p, q) = state.sub_jj(q, p) = data.sub_jj.value[v];
  }
}

LineState measured_start(const LineLayout& layout, const LineData& data) {
  const auto joint = at(layout.joint);
  LineState state{ComplexMatrix::Zero(joint, at(layout.others)), ComplexMatrix::Zero(joint, joint), {}, {}};
  take_measured(layout, data, state);
  return state;
}

void put_on_constraint(const LineLayout& layout, const ComplexMatrix& z, LineState& state) {
  const auto n = at(layout.joint), others = state.sub_jn.cols();
  if (layout.asm_jj.empty()) {
    state.asm_jn = others > 0 ? coupling::motion_with_joint(state.sub_jj, z, state.sub_jn)
                              : state.sub_jn;  // without columns there is nothing to solve
    return;
  }
  ComplexMatrix both(n, others + n);
  both << state.sub_jn, state.sub_jj;
  both = coupling::motion_with_joint(state.sub_jj, z, both);
  state.asm_jn = both.leftCols(others);
  state.asm_jj = both.rightCols(n);
}

Complex predicted_difference(const LineState& state, const ComplexMatrix& za, Element e) {
  const Complex *x = state.sub_jn.col(at(e.row)).data(), *g = za.col(at(e.column)).data();
  Complex sum = 0.0;
  for (Eigen::Index i = 0; i < za.rows(); ++i) sum += product(x[i], g[i]);
  return sum;
}

double line_cost(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, const ComplexMatrix& x,
                 const ComplexMatrix& y) {
  LineState state{x, y, {}, {}};
  return cost_on_constraint(layout, data, z, state);
}

double cost_on_constraint(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, LineState& state) {
  put_on_constraint(layout, z, state);
  if (data.correlation) return correlated_cost(layout, data, z, state);
  double cost = block_cost(layout.sub_jn, data.sub_jn, state.sub_jn) + block_cost(layout.sub_jj, data.sub_jj, state.sub_jj) +
                block_cost(layout.asm_jn, data.asm_jn, state.asm_jn);
  if (!layout.asm_jj.empty()) cost += block_cost(layout.asm_jj, data.asm_jj, state.asm_jj);
  const ComplexMatrix za = z * state.asm_jn;
  if (8 * layout.drop_nn.size() < layout.others * layout.others) {
    for (std::size_t i = 0; i < layout.drop_nn.size(); ++i)
      cost += square(data.drop_nn, i, predicted_difference(state, za, layout.drop_nn[i]));
    return cost;
  }
  const auto number = [](const ComplexMatrix& of) { return [&of](std::size_t i, std::size_t j) { return of(at(i), at(j)); }; };
  const LaneMatrix g(layout.joint, layout.others, number(za));
  const LaneMatrix x(layout.others, layout.joint, [&](std::size_t i, std::size_t j) { return state.sub_jn(at(j), at(i)); });
  LaneMatrix all(layout.others, layout.others);
  all.add_product(x.plain(), g.plain());
  for (std::size_t i = 0; i < layout.drop_nn.size(); ++i)
    cost += square(data.drop_nn, i, all(layout.drop_nn[i].row, layout.drop_nn[i].column));
  return cost;
}

}  // namespace jointid::ident
