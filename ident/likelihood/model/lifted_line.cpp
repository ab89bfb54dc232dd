#include "ident/likelihood/model/lifted_line.hpp"

#include <algorithm>
#include <array>

#include "base/eigen.hpp"
#include "coupling/joint_loop.hpp"

namespace jointid::ident {
namespace {

using RowMajorMap = Eigen::Map<RowMatrixXd>;

double largest(const Channel& channel) {
  double size = 0.0;
  for (const Complex& value : channel.value) size = std::max(size, std::abs(value));
  return size;
}

double variance(const Complex& weight) {
  const double larger = std::max(weight.real(), weight.imag());
  return larger > 0.0 ? 1.0 / (larger * larger) : 0.0;
}

}  // namespace

LiftedLine::LiftedLine(const LineLayout& layout, const LineData& data, const ComplexMatrix& z)
    : layout_(layout), z_(z), measured_(measured_start(layout, data)) {
  measured_.asm_jn = measured_.sub_jn;
  Channel all_a{std::vector<Complex>(layout.joint * layout.others), std::vector<Complex>(layout.joint * layout.others)};
  for (std::size_t i = 0; i < layout.asm_jn.size(); ++i) {
    if (data.asm_jn.weight[i] == Complex(0.0)) continue;
    measured_.asm_jn(at(layout.asm_jn[i].row), at(layout.asm_jn[i].column)) = data.asm_jn.value[i];
    all_a.weight[layout.asm_jn[i].column * layout.joint + layout.asm_jn[i].row] = data.asm_jn.weight[i];
  }
  const double size = std::max({largest(data.sub_jn), largest(data.sub_jj), largest(data.asm_jn)});
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, static_cast<const Channel*>(&all_a)}) add_scales(*channel, size);
  std::size_t first = 0;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.drop_nn}) {
    for (std::size_t i = 0; i < channel->value.size(); ++i) {
      const Complex weight = channel->weight[i], value = channel->value[i];
      if (weight.real() > 0.0) rows_.push_back({first + i, false, weight.real(), value.real(), false});
      if (weight.imag() > 0.0) rows_.push_back({first + i, true, weight.imag(), value.imag(), false});
    }
    first += channel->value.size();
  }
  add_conditions(data, first);
}

void LiftedLine::add_scales(const Channel& channel, double size) {
  for (const Complex& weight : channel.weight) {
    scale_.push_back(weight.real() > 0.0 ? 1.0 / weight.real() : size);
    scale_.push_back(weight.imag() > 0.0 ? 1.0 / weight.imag() : size);
  }
}

/// Var c = Var X + |I + Y Z|² Var A + Var Y |Z A|², squares element by element.
void LiftedLine::add_conditions(const LineData& data, std::size_t first) {
  const auto joint = at(layout_.joint), others = at(layout_.others);
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(joint, others), a = x, y = Eigen::MatrixXd::Zero(joint, joint);
  for (std::size_t i = 0; i < layout_.sub_jn.size(); ++i)
    x(at(layout_.sub_jn[i].row), at(layout_.sub_jn[i].column)) = variance(data.sub_jn.weight[i]);
  for (std::size_t i = 0; i < layout_.asm_jn.size(); ++i)
    a(at(layout_.asm_jn[i].row), at(layout_.asm_jn[i].column)) = variance(data.asm_jn.weight[i]);
  for (std::size_t i = 0; i < layout_.sub_jj.size(); ++i) {
    const auto [row, column] = layout_.sub_jj[i];
    y(at(row), at(column)) = y(at(column), at(row)) = variance(data.sub_jj.weight[i]);
  }
  const Eigen::MatrixXd spread = coupling::joint_loop(measured_.sub_jj, z_).cwiseAbs2();
  const Eigen::MatrixXd total = x + spread * a + y * (z_ * measured_.asm_jn).cwiseAbs2();
  for (Eigen::Index i = 0; i < total.size(); ++i) {
    const double weight = total.data()[i] > 0.0 ? 1.0 / std::sqrt(total.data()[i]) : 0.0;
    rows_.push_back({first + static_cast<std::size_t>(i), false, weight, 0.0, true});
    rows_.push_back({first + static_cast<std::size_t>(i), true, weight, 0.0, true});
  }
}

/// One of X, Y (both triangles) or A moved.
void LiftedLine::shift(std::size_t variable, const Complex& by, LineState& state) const {
  if (variable < layout_.sub_jn.size()) {
    state.sub_jn(at(layout_.sub_jn[variable].row), at(layout_.sub_jn[variable].column)) += by;
  } else if (variable < layout_.variables()) {
    const auto [row, column] = layout_.sub_jj[variable - layout_.sub_jn.size()];
    state.sub_jj(at(row), at(column)) += by;
    if (row != column) state.sub_jj(at(column), at(row)) += by;
  } else {
    state.asm_jn.data()[variable - layout_.variables()] += by;
  }
}

LineState LiftedLine::state(const double* u) const {
  LineState out = measured_;
  for (std::size_t v = 0; 2 * v < scale_.size(); ++v) shift(v, {scale_[2 * v] * u[2 * v], scale_[2 * v + 1] * u[2 * v + 1]}, out);
  return out;
}

std::vector<Complex> LiftedLine::stacked(const LineState& state, const ComplexMatrix& d, const ComplexMatrix& condition) const {
  std::vector<Complex> all;
  for (const Element& e : layout_.sub_jn) all.push_back(state.sub_jn(at(e.row), at(e.column)));
  for (const Element& e : layout_.sub_jj) all.push_back(state.sub_jj(at(e.row), at(e.column)));
  for (const Element& e : layout_.asm_jn) all.push_back(state.asm_jn(at(e.row), at(e.column)));
  for (const Element& e : layout_.drop_nn) all.push_back(d(at(e.row), at(e.column)));
  all.insert(all.end(), condition.data(), condition.data() + condition.size());
  return all;
}

bool LiftedLine::evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const LineState now = state(parameters[0]);
  const ComplexMatrix za = z_ * now.asm_jn, xz = now.sub_jn.transpose() * z_, yz = now.sub_jj * z_;
  const std::vector<Complex> values = stacked(now, now.sub_jn.transpose() * za, now.sub_jn - now.asm_jn - now.sub_jj * za);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Complex& value = values[rows_[r].at];
    residuals[r] = weight_of(rows_[r]) * ((rows_[r].imaginary ? value.imag() : value.real()) - rows_[r].target);
  }
  if (!jacobians || !jacobians[0]) return true;
  RowMajorMap jacobian(jacobians[0], at(rows_.size()), at(scale_.size()));
  LineState way{ComplexMatrix::Zero(now.sub_jn.rows(), now.sub_jn.cols()),
                ComplexMatrix::Zero(now.sub_jj.rows(), now.sub_jj.cols()),
                ComplexMatrix::Zero(now.asm_jn.rows(), now.asm_jn.cols()),
                {}};
  for (std::size_t v = 0; 2 * v < scale_.size(); ++v) {
    shift(v, 1.0, way);
    const std::vector<Complex> change =
        stacked(way, way.sub_jn.transpose() * za + xz * way.asm_jn, way.sub_jn - way.asm_jn - way.sub_jj * za - yz * way.asm_jn);
    shift(v, -1.0, way);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Complex derivative = weight_of(rows_[r]) * change[rows_[r].at];
      jacobian(at(r), at(2 * v)) = scale_[2 * v] * (rows_[r].imaginary ? derivative.imag() : derivative.real());
      jacobian(at(r), at(2 * v + 1)) = scale_[2 * v + 1] * (rows_[r].imaginary ? derivative.real() : -derivative.imag());
    }
  }
  return true;
}

}  // namespace jointid::ident
