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
  append(layout.x, data.x, state.x);
  append(layout.y, data.y, state.y);
  append(layout.a, data.a, state.a);
  append(layout.b, data.b, state.b);
  const ComplexMatrix za = z * state.a;
  for (std::size_t i = 0; i < layout.d.size(); ++i) errors.push_back(weighted(data.d, i, predicted_difference(state, za, layout.d[i])));
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
  for (const Element& e : layout.x) x(at(e.row), at(e.column)) += next();
  for (const Element& e : layout.y) {
    const Complex change = next();
    y(at(e.row), at(e.column)) += change;
    if (e.row != e.column) y(at(e.column), at(e.row)) += change;
  }
}

void take_measured(const LineLayout& layout, const LineData& data, LineState& state) {
  for (std::size_t v = 0; v < layout.x.size(); ++v) {
    if (data.x.weight[v] != Complex(0.0)) state.x(at(layout.x[v].row), at(layout.x[v].column)) = data.x.value[v];
  }
  for (std::size_t v = 0; v < layout.y.size(); ++v) {
    if (data.y.weight[v] == Complex(0.0)) continue;
    const auto p = at(layout.y[v].row), q = at(layout.y[v].column);
    state.y(p, q) = state.y(q, p) = data.y.value[v];
  }
}

LineState measured_start(const LineLayout& layout, const LineData& data) {
  const auto joint = at(layout.joint);
  LineState state{ComplexMatrix::Zero(joint, at(layout.others)), ComplexMatrix::Zero(joint, joint), {}, {}};
  take_measured(layout, data, state);
  return state;
}

void put_on_constraint(const LineLayout& layout, const ComplexMatrix& z, LineState& state) {
  const auto n = at(layout.joint), others = state.x.cols();
  if (layout.b.empty()) {
    state.a = others > 0 ? coupling::motion_with_joint(state.y, z, state.x) : state.x;  // without columns there is nothing to solve
    return;
  }
  ComplexMatrix both(n, others + n);
  both << state.x, state.y;
  both = coupling::motion_with_joint(state.y, z, both);
  state.a = both.leftCols(others);
  state.b = both.rightCols(n);
}

Complex predicted_difference(const LineState& state, const ComplexMatrix& za, Element e) {
  const Complex *x = state.x.col(at(e.row)).data(), *g = za.col(at(e.column)).data();
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
  double cost = block_cost(layout.x, data.x, state.x) + block_cost(layout.y, data.y, state.y) + block_cost(layout.a, data.a, state.a);
  if (!layout.b.empty()) cost += block_cost(layout.b, data.b, state.b);
  const ComplexMatrix za = z * state.a;
  if (8 * layout.d.size() < layout.others * layout.others) {
    for (std::size_t i = 0; i < layout.d.size(); ++i) cost += square(data.d, i, predicted_difference(state, za, layout.d[i]));
    return cost;
  }
  const auto number = [](const ComplexMatrix& of) { return [&of](std::size_t i, std::size_t j) { return of(at(i), at(j)); }; };
  const LaneMatrix g(layout.joint, layout.others, number(za));
  const LaneMatrix x(layout.others, layout.joint, [&](std::size_t i, std::size_t j) { return state.x(at(j), at(i)); });
  LaneMatrix all(layout.others, layout.others);
  all.add_product(x.plain(), g.plain());
  for (std::size_t i = 0; i < layout.d.size(); ++i) cost += square(data.d, i, all(layout.d[i].row, layout.d[i].column));
  return cost;
}

}  // namespace jointid::ident
