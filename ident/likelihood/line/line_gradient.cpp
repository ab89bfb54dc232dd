#include "ident/likelihood/line/line_gradient.hpp"

#include "base/eigen.hpp"
#include "dense/lu.hpp"

namespace jointid::ident {
namespace {

/// Weight² · residual of what is measured; adds what it is of χ².
Complex weighed(const Channel& channel, std::size_t i, const Complex& predicted, double& cost) {
  const Complex residual = channel.value[i] - predicted, weight = channel.weight[i];
  const double re = weight.real() == 0.0 ? 0.0 : residual.real() * weight.real();
  const double im = weight.imag() == 0.0 ? 0.0 : residual.imag() * weight.imag();
  cost += re * re + im * im;
  return {re * weight.real(), im * weight.imag()};
}

ComplexMatrix weighed(const std::vector<Element>& elements, const Channel& channel, const ComplexMatrix& predicted, double& cost) {
  ComplexMatrix out = ComplexMatrix::Zero(predicted.rows(), predicted.cols());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto row = at(elements[i].row), column = at(elements[i].column);
    out(row, column) = weighed(channel, i, predicted(row, column), cost);
  }
  return out;
}

}  // namespace

bool has_plain_errors(const LineData& data) { return !data.correlation && !data.terms; }

LineGradient gradient_of(const LineLayout& layout, const LineData& data, const JointImpedance& joint, const ComplexMatrix& z,
                         const LineState& state) {
  LineGradient out;
  const auto n = state.y.rows();
  const ComplexMatrix p = dense::inverse(ComplexMatrix::Identity(n, n) + state.y * z), b = p * state.y, g = z * state.a;
  const ComplexMatrix e_d = weighed(layout.d, data.d, state.x.transpose() * g, out.cost);
  const ComplexMatrix e_a = weighed(layout.a, data.a, state.a, out.cost);
  const ComplexMatrix by_a = p.adjoint() * e_a, by_d = g.conjugate() * e_d;
  ComplexMatrix by_x = weighed(layout.x, data.x, state.x, out.cost) + by_a + by_d;
  by_x.noalias() += g.conjugate() * e_d.transpose();
  ComplexMatrix by_y = -(by_a + by_d) * g.adjoint();
  ComplexMatrix answered = e_a * state.a.adjoint();
  if (!layout.b.empty()) {
    const ComplexMatrix e_b = weighed(layout.b, data.b, b, out.cost);
    by_y += p.adjoint() * e_b * p.conjugate();
    answered += e_b * b.adjoint();
  }
  out.joint = joint.along(state.a.conjugate() * e_d * state.a.adjoint() - b.adjoint() * answered);
  out.own.resize(at(2 * layout.variables()));
  Eigen::Index v = 0;
  const auto put = [&](const Complex& value) {
    out.own[v++] = value.real();
    out.own[v++] = value.imag();
  };
  for (const auto [row, column] : layout.x) put(by_x(at(row), at(column)));
  for (std::size_t i = 0; i < layout.y.size(); ++i) {
    const auto row = at(layout.y[i].row), column = at(layout.y[i].column);
    const Complex measured = weighed(data.y, i, state.y(row, column), out.cost);
    put(measured + (row == column ? by_y(row, row) : by_y(row, column) + by_y(column, row)));
  }
  return out;
}

}  // namespace jointid::ident
