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
  measured_.a = measured_.x;
  Channel all_a{std::vector<Complex>(layout.joint * layout.others), std::vector<Complex>(layout.joint * layout.others)};
  for (std::size_t i = 0; i < layout.a.size(); ++i) {
    if (data.a.weight[i] == Complex(0.0)) continue;
    measured_.a(at(layout.a[i].row), at(layout.a[i].column)) = data.a.value[i];
    all_a.weight[layout.a[i].column * layout.joint + layout.a[i].row] = data.a.weight[i];
  }
  const double size = std::max({largest(data.x), largest(data.y), largest(data.a)});
  for (const Channel* channel : {&data.x, &data.y, static_cast<const Channel*>(&all_a)}) add_scales(*channel, size);
  std::size_t first = 0;
  for (const Channel* channel : {&data.x, &data.y, &data.a, &data.d}) {
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
  for (std::size_t i = 0; i < layout_.x.size(); ++i) x(at(layout_.x[i].row), at(layout_.x[i].column)) = variance(data.x.weight[i]);
  for (std::size_t i = 0; i < layout_.a.size(); ++i) a(at(layout_.a[i].row), at(layout_.a[i].column)) = variance(data.a.weight[i]);
  for (std::size_t i = 0; i < layout_.y.size(); ++i) {
    const auto [row, column] = layout_.y[i];
    y(at(row), at(column)) = y(at(column), at(row)) = variance(data.y.weight[i]);
  }
  const Eigen::MatrixXd spread = coupling::joint_loop(measured_.y, z_).cwiseAbs2();
  const Eigen::MatrixXd total = x + spread * a + y * (z_ * measured_.a).cwiseAbs2();
  for (Eigen::Index i = 0; i < total.size(); ++i) {
    const double weight = total.data()[i] > 0.0 ? 1.0 / std::sqrt(total.data()[i]) : 0.0;
    rows_.push_back({first + static_cast<std::size_t>(i), false, weight, 0.0, true});
    rows_.push_back({first + static_cast<std::size_t>(i), true, weight, 0.0, true});
  }
}

/// One of X, Y (both triangles) or A moved.
void LiftedLine::shift(std::size_t variable, const Complex& by, LineState& state) const {
  if (variable < layout_.x.size()) {
    state.x(at(layout_.x[variable].row), at(layout_.x[variable].column)) += by;
  } else if (variable < layout_.variables()) {
    const auto [row, column] = layout_.y[variable - layout_.x.size()];
    state.y(at(row), at(column)) += by;
    if (row != column) state.y(at(column), at(row)) += by;
  } else {
    state.a.data()[variable - layout_.variables()] += by;
  }
}

LineState LiftedLine::state(const double* u) const {
  LineState out = measured_;
  for (std::size_t v = 0; 2 * v < scale_.size(); ++v) shift(v, {scale_[2 * v] * u[2 * v], scale_[2 * v + 1] * u[2 * v + 1]}, out);
  return out;
}

std::vector<Complex> LiftedLine::stacked(const LineState& state, const ComplexMatrix& d, const ComplexMatrix& condition) const {
  std::vector<Complex> all;
  for (const Element& e : layout_.x) all.push_back(state.x(at(e.row), at(e.column)));
  for (const Element& e : layout_.y) all.push_back(state.y(at(e.row), at(e.column)));
  for (const Element& e : layout_.a) all.push_back(state.a(at(e.row), at(e.column)));
  for (const Element& e : layout_.d) all.push_back(d(at(e.row), at(e.column)));
  all.insert(all.end(), condition.data(), condition.data() + condition.size());
  return all;
}

bool LiftedLine::evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const LineState now = state(parameters[0]);
  const ComplexMatrix za = z_ * now.a, xz = now.x.transpose() * z_, yz = now.y * z_;
  const std::vector<Complex> values = stacked(now, now.x.transpose() * za, now.x - now.a - now.y * za);
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Complex& value = values[rows_[r].at];
    residuals[r] = weight_of(rows_[r]) * ((rows_[r].imaginary ? value.imag() : value.real()) - rows_[r].target);
  }
  if (!jacobians || !jacobians[0]) return true;
  RowMajorMap jacobian(jacobians[0], at(rows_.size()), at(scale_.size()));
  LineState way{ComplexMatrix::Zero(now.x.rows(), now.x.cols()), ComplexMatrix::Zero(now.y.rows(), now.y.cols()),
                ComplexMatrix::Zero(now.a.rows(), now.a.cols()), {}};
  for (std::size_t v = 0; 2 * v < scale_.size(); ++v) {
    shift(v, 1.0, way);
    const std::vector<Complex> change = stacked(way, way.x.transpose() * za + xz * way.a, way.x - way.a - way.y * za - yz * way.a);
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
