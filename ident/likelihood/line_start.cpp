#include "ident/likelihood/line_start.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace jointid::ident {
namespace {

/// An FRF that was not measured may be this many times as large as those around it.
constexpr double wide = 1e3;

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

double largest(const Channel& channel) {
  double size = 0.0;
  for (const Complex& value : channel.value) size = std::max(size, std::abs(value));
  return size;
}

/// Real rows of a least-squares problem in the free FRFs, real and imaginary part in turn.
class Rows {
 public:
  Rows(std::size_t variables, std::size_t most) : left_(Eigen::MatrixXd::Zero(at(most), at(2 * variables))), right_(Eigen::VectorXd::Zero(at(most))) {}

  void add_real(std::size_t column, double weight, double value) {
    left_(used_, at(column)) = weight;
    right_[used_++] = weight * value;
  }

  void add(const Eigen::VectorXcd& coefficients, double weight, const Complex& value) {
    for (Eigen::Index v = 0; v < coefficients.size(); ++v) {
      const Complex c = weight * coefficients[v];
      left_(used_, 2 * v) = left_(used_ + 1, 2 * v + 1) = c.real();
      left_(used_, 2 * v + 1) = -c.imag();
      left_(used_ + 1, 2 * v) = c.imag();
    }
    right_[used_++] = weight * value.real();
    right_[used_++] = weight * value.imag();
  }

  LineStep solve() const { return left_.topRows(used_).colPivHouseholderQr().solve(right_.head(used_)); }

 private:
  Eigen::MatrixXd left_;
  Eigen::VectorXd right_;
  Eigen::Index used_ = 0;
};

void add_measured(const Channel& channel, std::size_t first, double size, Rows& rows) {
  for (std::size_t i = 0; i < channel.value.size(); ++i) {
    const Complex value = channel.value[i], weight = channel.weight[i];
    const auto add = [&](std::size_t column, double of, double part) {
      rows.add_real(column, of > 0.0 ? of : 1.0 / (wide * size), of > 0.0 ? part : 0.0);
    };
    add(2 * (first + i), weight.real(), value.real());
    add(2 * (first + i) + 1, weight.imag(), value.imag());
  }
}

/// A measured block of the assembly and its variances as matrices, zero where not measured.
struct Block {
  ComplexMatrix value;
  Eigen::MatrixXd variance;
  std::vector<std::size_t> measured;  ///< per column

  Block(const std::vector<Element>& elements, const Channel& channel, std::size_t rows, std::size_t columns, bool symmetric)
      : value(ComplexMatrix::Zero(at(rows), at(columns))), variance(Eigen::MatrixXd::Zero(at(rows), at(columns))), measured(columns) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Complex weight = channel.weight[i];
      if (weight.real() == 0.0 || weight.imag() == 0.0) continue;
      set(elements[i], channel.value[i], weight);
      if (symmetric && elements[i].row != elements[i].column) set({elements[i].column, elements[i].row}, channel.value[i], weight);
    }
  }

  void set(Element e, const Complex& to, const Complex& weight) {
    value(at(e.row), at(e.column)) = to;
    variance(at(e.row), at(e.column)) = 1.0 / std::max(weight.real(), weight.imag()) / std::max(weight.real(), weight.imag());
    ++measured[e.column];
  }
};

/// Coefficients of −(Y right)(p, k).
void add_y(const LineLayout& layout, const ComplexMatrix& right, std::size_t p, std::size_t k, Eigen::VectorXcd& coefficients) {
  for (std::size_t v = 0; v < layout.y.size(); ++v) {
    const auto [row, column] = layout.y[v];
    Complex& c = coefficients[at(layout.x.size() + v)];
    if (row == p) c -= right(at(column), at(k));
    if (column == p && row != column) c -= right(at(row), at(k));
  }
}

/// Weight of condition (p, k): errors of A enter it through I + Y Z.
double weight_of(const Eigen::MatrixXd& spread, const Block& block, std::size_t p, std::size_t k) {
  return 1.0 / std::sqrt(spread.row(at(p)).dot(block.variance.col(at(k))));
}

}  // namespace

LineState measured_start(const LineLayout& layout, const LineData& data) {
  LineState out{ComplexMatrix::Zero(at(layout.joint), at(layout.others)), ComplexMatrix::Zero(at(layout.joint), at(layout.joint)), {}, {}};
  LineStep step(at(2 * layout.variables()));
  Eigen::Index v = 0;
  for (const Channel* channel : {&data.x, &data.y}) {
    for (const Complex& value : channel->value) {
      step[v++] = value.real();
      step[v++] = value.imag();
    }
  }
  move(layout, step, 1.0, out.x, out.y);
  return out;
}

LineState assembly_start(const LineLayout& layout, const LineData& data, const ComplexMatrix& z) {
  const std::size_t joint = layout.joint, v = layout.variables();
  const LineState measured = measured_start(layout, data);
  const Eigen::MatrixXd spread = (ComplexMatrix::Identity(at(joint), at(joint)) + measured.y * z).cwiseAbs2();
  const Block a(layout.a, data.a, joint, layout.others, false), b(layout.b, data.b, joint, joint, true);
  const ComplexMatrix za = z * a.value, zb = ComplexMatrix::Identity(at(joint), at(joint)) - z * b.value;
  Rows rows(v, 2 * (v + joint * (layout.others + joint)));
  add_measured(data.x, 0, std::max(largest(data.x), largest(data.a)), rows);
  add_measured(data.y, layout.x.size(), std::max(largest(data.y), largest(data.a)), rows);
  const auto add = [&](const Block& block, bool is_a) {
    for (std::size_t k = 0; k < block.measured.size(); ++k) {
      for (std::size_t p = 0; p < joint && block.measured[k] == joint; ++p) {
        Eigen::VectorXcd coefficients = Eigen::VectorXcd::Zero(at(v));
        for (std::size_t i = 0; is_a && i < layout.x.size(); ++i) {
          if (layout.x[i].row == p && layout.x[i].column == k) coefficients[at(i)] = 1.0;
        }
        add_y(layout, is_a ? za : ComplexMatrix(-zb), p, k, coefficients);
        rows.add(coefficients, weight_of(spread, block, p, k), block.value(at(p), at(k)));
      }
    }
  };
  add(a, true);
  add(b, false);
  LineState out{ComplexMatrix::Zero(at(joint), at(layout.others)), ComplexMatrix::Zero(at(joint), at(joint)), {}, {}};
  move(layout, rows.solve(), 1.0, out.x, out.y);
  return out;
}

}  // namespace jointid::ident
