#include "ident/likelihood/model/line_gradient.hpp"

#include "base/eigen.hpp"
#include "coupling/joint_loop.hpp"
#include "ident/likelihood/line/lane_matrix.hpp"

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

/// The same of a block, as a matrix.
LaneMatrix weighed(const std::vector<Element>& elements, const Channel& channel, const LaneMatrix& predicted, double& cost) {
  LaneMatrix out(predicted.rows(), predicted.columns());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto [row, column] = elements[i];
    out.put(row, column, weighed(channel, i, predicted(row, column), cost));
  }
  return out;
}

LaneMatrix split(const ComplexMatrix& matrix) {
  return {static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()),
          [&](std::size_t i, std::size_t j) { return matrix(at(i), at(j)); }};
}

}  // namespace

bool has_plain_errors(const LineData& data) { return !data.correlation && !data.terms; }

LineGradient gradient_of(const LineLayout& layout, const LineData& data, const JointImpedance& joint, const ComplexMatrix& z,
                         const LineState& state) {
  LineGradient out;
  const std::size_t n = layout.joint, others = layout.others;
  const ComplexMatrix inverse = coupling::closed_loop(state.sub_jj, z);
  const LaneMatrix p = split(inverse), p_h = split(inverse.adjoint()), a = split(state.asm_jn);
  LaneMatrix b(n, n), g(n, others), d(others, others);
  b.add_product(p.plain(), split(state.sub_jj).plain());
  g.add_product(split(z).plain(), a.plain());
  d.add_product(split(state.sub_jn.transpose()).plain(), g.plain());
  const LaneMatrix e_d = weighed(layout.drop_nn, data.drop_nn, d, out.cost),
                   e_a = weighed(layout.asm_jn, data.asm_jn, a, out.cost);
  LaneMatrix by_x(n, others), by_y(n, n), by_z(n, n), answered(n, n), driven(n, others);
  by_x.add_product(p_h.plain(), e_a.plain());
  by_x.add_product(g.conjugate(), e_d.plain());
  by_y.add_product(by_x.plain(), g.adjoint(), -1.0);
  by_x.add_product(g.conjugate(), e_d.transpose());
  answered.add_product(e_a.plain(), a.adjoint());
  if (!layout.asm_jj.empty()) {
    const LaneMatrix e_b = weighed(layout.asm_jj, data.asm_jj, b, out.cost);
    LaneMatrix through(n, n);
    through.add_product(p_h.plain(), e_b.plain());
    by_y.add_product(through.plain(), p.conjugate());
    answered.add_product(e_b.plain(), b.adjoint());
  }
  driven.add_product(a.conjugate(), e_d.plain());
  by_z.add_product(driven.plain(), a.adjoint());
  by_z.add_product(LaneMatrix(n, n, [&b](std::size_t i, std::size_t j) { return b(j, i); }).conjugate(), answered.plain(), -1.0);
  out.joint = joint.along(ComplexMatrix::NullaryExpr(at(n), at(n), [&by_z](Eigen::Index i, Eigen::Index j) {
    return by_z(static_cast<std::size_t>(i), static_cast<std::size_t>(j));
  }));
  out.own.resize(at(2 * layout.variables()));
  Eigen::Index v = 0;
  const auto put = [&](const Complex& value) {
    out.own[v++] = value.real();
    out.own[v++] = value.imag();
  };
  for (std::size_t i = 0; i < layout.sub_jn.size(); ++i) {
    const auto [row, column] = layout.sub_jn[i];
    put(weighed(data.sub_jn, i, state.sub_jn(at(row), at(column)), out.cost) + by_x(row, column));
  }
  for (std::size_t i = 0; i < layout.sub_jj.size(); ++i) {
    const auto [row, column] = layout.sub_jj[i];
    const Complex measured = weighed(data.sub_jj, i, state.sub_jj(at(row), at(column)), out.cost);
    put(measured + (row == column ? by_y(row, row) : by_y(row, column) + by_y(column, row)));
  }
  return out;
}

}  // namespace jointid::ident
