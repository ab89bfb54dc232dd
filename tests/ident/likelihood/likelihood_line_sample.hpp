#pragma once

#include <Eigen/Core>
#include <random>
#include <string>

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// What a random line looks like.
struct LineShape {
  std::size_t others = 3, joint = 2;
  bool with_b = true;
  bool undriven = false;   ///< some other coordinates are no references: none of their FRFs with each other is known
  bool uncoupled = false;  ///< two parts, whose cross FRFs are zero by construction
  double missing = 0.0;    ///< share of the FRFs that are not measured
  double noise = 0.1;      ///< standard deviation of the errors and of the weights
  bool correlated = false; ///< two groups of measured FRFs whose errors depend on each other; what is drawn is independent all the same
};

/// A small problem of one line with FRFs and impedances of order one; K is symmetric, C diagonal.
class LineSample {
 public:
  LineSample(const LineShape& shape, std::mt19937_64& random)
      : layout(layout_of(shape, random)),
        restriction(restrictions::build({spec(shape.joint)})),
        columns(restriction, {spec(shape.joint)}),
        joint(joint_at(restriction, columns, 3.0, 2.0)),
        random_(random) {
    const auto n = index(shape.others), j = index(shape.joint);
    for (std::size_t i = 0; i < columns.size(); ++i) theta.push_back(0.4 * normal());
    exact = {ComplexMatrix::Zero(j, n), ComplexMatrix::Zero(j, j), {}, {}};
    for (const Element& e : layout.sub_jn) exact.sub_jn(index(e.row), index(e.column)) = any();
    for (const Element& e : layout.sub_jj)
      exact.sub_jj(index(e.row), index(e.column)) = exact.sub_jj(index(e.column), index(e.row)) = any();
    const ComplexMatrix z = joint.at(theta);
    put_on_constraint(layout, z, exact);
    const ComplexMatrix d = exact.sub_jn.transpose() * z * exact.asm_jn;
    data.omega = 2.0;
    measure(layout.sub_jn, exact.sub_jn, shape, data.sub_jn);
    measure(layout.sub_jj, exact.sub_jj, shape, data.sub_jj);
    measure(layout.asm_jn, exact.asm_jn, shape, data.asm_jn);
    measure(layout.asm_jj, exact.asm_jj, shape, data.asm_jj);
    measure(layout.drop_nn, d, shape, data.drop_nn);
    if (shape.correlated) correlate();
  }

  static Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }
  double normal() { return std::normal_distribution<double>()(random_); }
  Complex any() { return {normal(), normal()}; }
  ComplexMatrix any(const ComplexMatrix& like) {
    return like.unaryExpr([this](const Complex&) { return any(); });
  }

  LineLayout layout;
  restrictions::Restriction restriction;
  UnknownColumns columns;
  JointImpedance joint;
  std::vector<double> theta;
  LineState exact;
  LineData data;
  Eigen::MatrixXcd correlation;  ///< of all elements, where they are correlated

 private:
  /// Measured elements at random in one of two groups, or in none.
  void correlate() {
    std::vector<Complex> weights;
    for (const Channel* channel : {&data.sub_jn, &data.sub_jj, &data.asm_jn, &data.asm_jj, &data.drop_nn}) {
      weights.insert(weights.end(), channel->weight.begin(), channel->weight.end());
    }
    correlation = Eigen::MatrixXcd::Identity(index(weights.size()), index(weights.size()));
    std::uniform_int_distribution<int> group(0, 2);
    std::vector<std::size_t> some;
    std::vector<int> groups;
    Eigen::VectorXd variance(correlation.rows());
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (weights[i] == Complex(0.0)) continue;
      variance[index(some.size())] = 0.5 + std::norm(any());
      some.push_back(i);
      groups.push_back(group(random_));
    }
    const Eigen::Index count = index(some.size());
    variance.conservativeResize(count);
    const Eigen::MatrixXcd root = Eigen::MatrixXcd::NullaryExpr(count, 2 * count, [this] { return any(); });
    Eigen::MatrixXcd covariance = root * root.adjoint();
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        const int a = groups[static_cast<std::size_t>(i)], b = groups[static_cast<std::size_t>(j)];
        if (i != j && (a != b || a == 0)) covariance(i, j) = 0.0;
      }
    }
    const Eigen::VectorXd scale = (variance.array() / covariance.diagonal().real().array()).sqrt();
    covariance = (scale.asDiagonal() * covariance * scale.asDiagonal()).eval();
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j < count; ++j) {
        correlation(index(some[static_cast<std::size_t>(i)]), index(some[static_cast<std::size_t>(j)])) =
            covariance(i, j) / std::sqrt(variance[i] * variance[j]);
      }
    }
    data.correlation =
        std::make_shared<minimise::Correlation>(minimise::Correlation::of(weights.size(), some, covariance, variance));
  }

  static restrictions::JointSpec spec(std::size_t joint) {
    restrictions::JointSpec spec;
    for (std::size_t i = 1; i <= joint; ++i) spec.dofs.push_back(frf::Dof::parse(std::to_string(i) + ":+X"));
    spec.matrices = {{restrictions::Kind::stiffness, restrictions::Pattern::symmetric},
                     {restrictions::Kind::viscous_damping, restrictions::Pattern::diagonal}};
    return spec;
  }

  static LineLayout layout_of(const LineShape& shape, std::mt19937_64& random) {
    std::bernoulli_distribution coin;
    const auto part = [&](std::size_t count) {
      std::vector<bool> second;
      for (std::size_t i = 0; i < count; ++i) second.push_back(shape.uncoupled && coin(random));
      return second;
    };
    const std::vector<bool> other = part(shape.others), joint = part(shape.joint);
    std::vector<bool> undriven(shape.others, false);
    for (std::size_t k = 0; shape.undriven && k < shape.others; ++k) undriven[k] = coin(random);
    LineLayout layout;
    layout.others = shape.others;
    layout.joint = shape.joint;
    layout.sub_jn_first = {0};
    for (std::size_t k = 0; k < shape.others; ++k) {
      for (std::size_t p = 0; p < shape.joint; ++p) {
        if (other[k] == joint[p]) layout.sub_jn.push_back({p, k});
        layout.asm_jn.push_back({p, k});
      }
      for (std::size_t r = 0; r <= k; ++r) {
        if (!undriven[r] || !undriven[k]) layout.drop_nn.push_back({r, k});
      }
      layout.sub_jn_first.push_back(layout.sub_jn.size());
    }
    for (std::size_t q = 0; q < shape.joint; ++q) {
      for (std::size_t p = 0; p <= q; ++p) {
        if (joint[p] == joint[q]) layout.sub_jj.push_back({p, q});
        if (shape.with_b) layout.asm_jj.push_back({p, q});
      }
    }
    return layout;
  }

  void measure(const std::vector<Element>& elements, const ComplexMatrix& exact_values, const LineShape& shape, Channel& out) {
    std::bernoulli_distribution missing(shape.missing);
    std::uniform_real_distribution<double> size(0.5, 2.0);
    for (const Element& e : elements) {
      const Complex sigma = shape.noise * Complex(size(random_), size(random_)), error = any();
      out.value.push_back(exact_values(index(e.row), index(e.column)) +
                          Complex(sigma.real() * error.real(), sigma.imag() * error.imag()));
      const bool absent = missing(random_);
      if (absent) out.value.back() = 0.0;
      out.weight.push_back(absent ? Complex(0.0) : Complex(1.0 / sigma.real(), 1.0 / sigma.imag()));
      data.measured += absent ? 0 : 2;
    }
  }

  std::mt19937_64& random_;
};

}  // namespace jointid::ident
