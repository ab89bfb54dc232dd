#include "ident/likelihood/model/explicit_line.hpp"

#include <algorithm>
#include <array>

#include "base/eigen.hpp"
#include "coupling/joint_loop.hpp"

namespace jointid::ident {
namespace {

/// What FRFs predict and all that its derivatives need.
struct Explicit {
  const ComplexMatrix &z, &x, &y;
  ComplexMatrix p, a, b, za, xz;

  Explicit(const ComplexMatrix& impedance, const ComplexMatrix& x_, const ComplexMatrix& y_) : z(impedance), x(x_), y(y_) {
    p = coupling::closed_loop(y, z);
    a = p * x;
    b = p * y;
    za = z * a;
    xz = x.transpose() * z;
  }

  ComplexMatrix d() const { return x.transpose() * za; }
};

/// Derivatives of A, B and D in one direction.
struct Derivative {
  ComplexMatrix a, b, d;

  Derivative(const Explicit& f, const ComplexMatrix& dx, const ComplexMatrix& dy) {
    a = f.p * (dx - dy * f.za);
    b = f.p * (dy - dy * f.z * f.b);
    d = dx.transpose() * f.za + f.xz * a;
  }

  Derivative(const Explicit& f, const ComplexMatrix& dz) {
    a = -f.p * f.y * dz * f.a;
    b = -f.p * f.y * dz * f.b;
    d = f.x.transpose() * dz * f.a + f.xz * a;
  }
};

}  // namespace

ExplicitLine::ExplicitLine(const LineLayout& layout, const LineData& data, const JointImpedance& joint)
    : layout_(&layout), columns_(joint.columns()), correlation_(data.correlation) {
  std::vector<double> theta(columns_.empty() ? 0 : *std::max_element(columns_.begin(), columns_.end()) + 1, 0.0);
  known_ = joint.at(theta);
  for (const std::size_t column : columns_) {
    theta[column] = 1.0;
    by_.push_back(joint.at(theta) - known_);
    theta[column] = 0.0;
  }
  std::size_t first = 0;
  for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
    for (std::size_t i = 0; i < channel->value.size(); ++i) {
      const Complex weight = channel->weight[i], value = channel->value[i];
      if (weight.real() > 0.0) rows_.push_back({first + i, false, weight.real(), value.real()});
      if (weight.imag() > 0.0) rows_.push_back({first + i, true, weight.imag(), value.imag()});
    }
    first += channel->value.size();
  }
  scale_.assign(own(), 0.0);
  for (const Row& row : rows_) {
    if (row.at < layout.variables()) scale_[2 * row.at + (row.imaginary ? 1 : 0)] = 1.0 / row.weight;
  }
}

void ExplicitLine::set_centre(const ComplexMatrix& x, const ComplexMatrix& y) {
  x_centre_ = x;
  y_centre_ = y;
  const double size = std::max(x.size() == 0 ? 0.0 : x.cwiseAbs().maxCoeff(), y.cwiseAbs().maxCoeff());
  std::replace(scale_.begin(), scale_.end(), 0.0, size);
}

ComplexMatrix ExplicitLine::impedance(std::span<const double> theta) const {
  ComplexMatrix z = known_;
  for (std::size_t t = 0; t < columns_.size(); ++t) z += theta[columns_[t]] * by_[t];
  return z;
}

LineState ExplicitLine::state(std::span<const double> theta, const double* u) const {
  LineState out{x_centre_, y_centre_, {}, {}};
  LineStep step(at(own()));
  for (std::size_t i = 0; i < own(); ++i) step[at(i)] = scale_[i] * u[i];
  move(*layout_, step, 1.0, out.sub_jn, out.sub_jj);
  const ComplexMatrix z = impedance(theta);
  Explicit predicted(z, out.sub_jn, out.sub_jj);
  out.asm_jn = std::move(predicted.a);
  out.asm_jj = std::move(predicted.b);
  return out;
}

std::vector<Complex> ExplicitLine::stacked(const ComplexMatrix& x, const ComplexMatrix& y, const ComplexMatrix& a,
                                           const ComplexMatrix& b, const ComplexMatrix& d) const {
  std::vector<Complex> all;
  const auto append = [&](const std::vector<Element>& elements, const ComplexMatrix& from) {
    for (const Element& e : elements) all.push_back(from(at(e.row), at(e.column)));
  };
  append(layout_->sub_jn, x);
  append(layout_->sub_jj, y);
  append(layout_->asm_jn, a);
  append(layout_->asm_jj, b);
  append(layout_->drop_nn, d);
  return all;
}

/// L⁻¹ of real and imaginary parts that belong together, column by column.
void ExplicitLine::whiten(Eigen::Ref<RowMatrixXd> rows) const {
  if (!correlation_) return;
  const std::size_t elements = layout_->variables() + layout_->asm_jn.size() + layout_->asm_jj.size() + layout_->drop_nn.size();
  for (Eigen::Index column = 0; column < rows.cols(); ++column) {
    std::vector<Complex> errors(elements);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      errors[rows_[r].at] += rows(at(r), column) * (rows_[r].imaginary ? Complex(0.0, 1.0) : Complex(1.0));
    }
    correlation_->whiten(errors);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Complex error = errors[rows_[r].at];
      rows(at(r), column) = rows_[r].imaginary ? error.imag() : error.real();
    }
  }
}

void ExplicitLine::evaluate(std::span<const double> theta, const double* u, double* residuals, RowMatrixXd* by_theta,
                            RowMatrixXd* by_own) const {
  const ComplexMatrix z = impedance(theta);
  const LineState now = state(theta, u);
  const Explicit f(z, now.sub_jn, now.sub_jj);
  const std::vector<Complex> values = stacked(f.x, f.y, f.a, f.b, f.d());
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    const Complex& value = values[rows_[r].at];
    residuals[r] = rows_[r].weight * ((rows_[r].imaginary ? value.imag() : value.real()) - rows_[r].measured);
  }
  whiten(Eigen::Map<RowMatrixXd>(residuals, at(rows_.size()), 1));
  const auto set = [&](RowMatrixXd& jacobian, std::size_t column, const std::vector<Complex>& change, const Complex& factor) {
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      const Complex derivative = factor * change[rows_[r].at];
      jacobian(at(r), at(column)) = rows_[r].weight * (rows_[r].imaginary ? derivative.imag() : derivative.real());
    }
  };
  ComplexMatrix dx = ComplexMatrix::Zero(f.x.rows(), f.x.cols()), dy = ComplexMatrix::Zero(f.y.rows(), f.y.cols());
  if (by_theta) {
    by_theta->setZero(at(rows_.size()), at(theta.size()));
    for (std::size_t t = 0; t < columns_.size(); ++t) {
      const Derivative along(f, by_[t]);
      set(*by_theta, columns_[t], stacked(dx, dy, along.a, along.b, along.d), 1.0);
    }
    whiten(*by_theta);
  }
  if (!by_own) return;
  by_own->resize(at(rows_.size()), at(own()));
  for (std::size_t v = 0; v < layout_->variables(); ++v) {
    const bool is_x = v < layout_->sub_jn.size();
    const Element e = is_x ? layout_->sub_jn[v] : layout_->sub_jj[v - layout_->sub_jn.size()];
    const auto put = [&](double to) {
      if (is_x) {
        dx(at(e.row), at(e.column)) = to;
      } else {
        dy(at(e.row), at(e.column)) = dy(at(e.column), at(e.row)) = to;
      }
    };
    put(1.0);
    const Derivative along(f, dx, dy);
    const std::vector<Complex> change = stacked(dx, dy, along.a, along.b, along.d);
    put(0.0);
    set(*by_own, 2 * v, change, scale_[2 * v]);
    set(*by_own, 2 * v + 1, change, Complex(0.0, scale_[2 * v + 1]));
  }
  whiten(*by_own);
}

}  // namespace jointid::ident
