#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/lu.hpp"
#include "dense/qr.hpp"
#include "dense/real_lu.hpp"
#include "dense/svd.hpp"
#include "ident/likelihood/model/line_gradient.hpp"
#include "ident/likelihood/model/line_model.hpp"
#include "likelihood_line_sample.hpp"

namespace jointid::ident {
namespace {

/// Independent ones from residuals whose errors are correlated, real and imaginary parts in turn, by the real covariance of the parts.
Eigen::VectorXd independent(const LineSample& s, Eigen::VectorXd residuals) {
  if (!s.data.correlation) return residuals;
  const Eigen::Index size = s.correlation.rows();
  Eigen::MatrixXd parts(2 * size, 2 * size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      const Complex rho = s.correlation(i, j);
      parts.block<2, 2>(2 * i, 2 * j) << rho.real(), -rho.imag(), rho.imag(), rho.real();
    }
  }
  Eigen::MatrixXd out = residuals;
  dense::solve_lower(*dense::cholesky(parts), out);
  return out;
}

/// Weighted residuals measured − predicted of a line, with the assembly as that of the coupled FRF matrix, (I + H Z)⁻¹ H.
Eigen::VectorXd residuals(const LineSample& s, const std::vector<double>& theta, const ComplexMatrix& x, const ComplexMatrix& y) {
  const auto n = x.cols(), j = x.rows();
  ComplexMatrix h = ComplexMatrix::Zero(n + j, n + j), z = h;
  h.bottomLeftCorner(j, n) = x;
  h.topRightCorner(n, j) = x.transpose();
  h.bottomRightCorner(j, j) = y;
  z.bottomRightCorner(j, j) = s.joint.at(theta);
  const ComplexMatrix coupled = dense::inverse(ComplexMatrix::Identity(n + j, n + j) + h * z) * h, difference = h - coupled;
  std::vector<double> all;
  const auto add = [&](const std::vector<Element>& elements, const Channel& channel, const ComplexMatrix& predicted) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      const Complex off = channel.value[i] - predicted(at(elements[i].row), at(elements[i].column));
      all.push_back(off.real() * channel.weight[i].real());
      all.push_back(off.imag() * channel.weight[i].imag());
    }
  };
  add(s.layout.sub_jn, s.data.sub_jn, x);
  add(s.layout.sub_jj, s.data.sub_jj, y);
  add(s.layout.asm_jn, s.data.asm_jn, coupled.bottomLeftCorner(j, n));
  add(s.layout.asm_jj, s.data.asm_jj, coupled.bottomRightCorner(j, j));
  add(s.layout.drop_nn, s.data.drop_nn, difference.topLeftCorner(n, n));
  return independent(s, Eigen::Map<Eigen::VectorXd>(all.data(), at(all.size())));
}

/// ∂residuals/∂(X, Y, θ) at a state by central differences.
Eigen::MatrixXd jacobian(const LineSample& s, const LineState& state, double h = 1e-6) {
  const auto v = at(2 * s.layout.variables()), p = at(s.theta.size());
  const auto moved = [&](Eigen::Index i, double by) {
    ComplexMatrix x = state.sub_jn, y = state.sub_jj;
    std::vector<double> theta = s.theta;
    if (i < v) move(s.layout, Eigen::VectorXd::Unit(v, i), by, x, y);
    if (i >= v) theta[static_cast<std::size_t>(i - v)] += by;
    return residuals(s, theta, x, y);
  };
  Eigen::MatrixXd out(residuals(s, s.theta, state.sub_jn, state.sub_jj).size(), v + p);
  for (Eigen::Index i = 0; i < v + p; ++i) out.col(i) = (moved(i, h) - moved(i, -h)) / (2.0 * h);
  return out;
}

LineShape any_shape(std::mt19937_64& random) {
  const auto up_to = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(1, most)(random); };
  std::bernoulli_distribution coin;
  return {.others = up_to(6),
          .joint = up_to(4),
          .with_b = coin(random),
          .uncoupled = coin(random),
          .missing = coin(random) ? 0.15 : 0.0,
          .correlated = coin(random)};
}

/// The FRFs of the sample somewhat off, on the constraint.
LineState nearby(LineSample& s) {
  LineState state = s.exact;
  LineStep step(at(2 * s.layout.variables()));
  for (double& value : step) value = s.normal();
  move(s.layout, step, 0.05, state.sub_jn, state.sub_jj);
  put_on_constraint(s.layout, s.joint.at(s.theta), state);
  return state;
}

void expect_close(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance, double floor = 1e-3) {
  RC_ASSERT((a - b).norm() <= tolerance * (floor + b.norm()));
}

RC_GTEST_PROP(LikelihoodLine, CostIsTheSumOfSquares, (unsigned seed)) {
  std::mt19937_64 random(seed);
  LineSample s(any_shape(random), random);
  const LineState state = nearby(s);
  const double plain = residuals(s, s.theta, state.sub_jn, state.sub_jj).squaredNorm();
  const double cost = line_cost(s.layout, s.data, s.joint.at(s.theta), state.sub_jn, state.sub_jj);
  RC_ASSERT(std::abs(cost - plain) <= (s.data.correlation ? 1e-8 : 1e-10) * plain);
}

/// Rows of the linearised line in (X, Y, θ), the residuals last; differences `j` are its derivatives. What was not measured gets
/// a row 1/(10³ · the largest) δ.
Eigen::MatrixXd equations(const LineSample& s, const LineState& state, const Eigen::MatrixXd& j) {
  const auto v = at(2 * s.layout.variables());
  const double x_size = state.sub_jn.cwiseAbs().maxCoeff(), y_size = state.sub_jj.cwiseAbs().maxCoeff();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(j.rows() + v, j.cols() + 1);
  rows.topRows(j.rows()) << j, residuals(s, s.theta, state.sub_jn, state.sub_jj);
  for (Eigen::Index i = 0; i < v; ++i) {
    const bool is_x = i < at(2 * s.layout.sub_jn.size());
    if (j.col(i)[i] == 0.0) rows(j.rows() + i, i) = 1e-3 / (is_x ? x_size : y_size);
  }
  return rows;
}

/// On the constraint the linearised line is the plain least-squares problem in (X, Y, θ) with X and Y eliminated.
RC_GTEST_PROP(LikelihoodLine, ReducesToTheSchurComplementOfDifferences, (unsigned seed)) {
  std::mt19937_64 random(seed);
  LineSample s(any_shape(random), random);
  const LineState state = nearby(s);
  LineModel model(s.layout);
  model.linearise(s.data, s.joint, s.joint.at(s.theta), state, true);
  const auto reduced = model.reduce(0.0);
  RC_PRE(reduced.has_value());
  Eigen::MatrixXd j = -jacobian(s, state);
  RC_PRE((j + jacobian(s, state, 3e-6)).norm() <=
         1e-7 * j.norm());  // differences tell the derivative: no pole of I + ZY close by
  const auto v = at(2 * s.layout.variables()), p = j.cols() - v;
  const Eigen::MatrixXd rows = equations(s, state, j);
  const Eigen::MatrixXd q = dense::orthonormal_columns(rows.leftCols(v)), told = q.transpose() * rows.leftCols(v);
  const Eigen::MatrixXd rotated = q.transpose() * rows.rightCols(p + 1), solved = dense::RealLu(told).solve(rotated);
  const Eigen::MatrixXd rest = rows.rightCols(p + 1) - q * rotated;
  const Eigen::MatrixXd schur = rest.transpose() * rest;
  const double cancelled = 1e-3 + 1e-2 * rows.rightCols(p + 1).squaredNorm();  // what the FRFs' steps take off again
  expect_close(reduced->information, schur.topLeftCorner(p, p), 1e-5, cancelled);
  expect_close(reduced->gradient, schur.topRightCorner(p, 1), 1e-5, cancelled);
  expect_close(Eigen::MatrixXd::Constant(1, 1, reduced->cost), schur.bottomRightCorner(1, 1), 1e-5, cancelled);
  // The FRFs' steps as far as the equations tell them: differences are too coarse for what only the weak rows fix.
  expect_close(told * reduced->back->matrix(), told * solved.leftCols(p), 1e-4);
  expect_close(told * reduced->own, told * solved.rightCols(1), 1e-4);
}

/// By adjoints what the normal equations have by rows, for real and complex ones: the gradient of the joint with the FRFs eliminated,
/// and their step.
RC_GTEST_PROP(LikelihoodLine, GradientIsThatOfTheNormalEquations, (unsigned seed, bool circular)) {
  std::mt19937_64 random(seed);
  LineShape shape = any_shape(random);
  shape.correlated = false;
  LineSample s(shape, random);
  if (circular) {
    for (Channel* channel : {&s.data.sub_jn, &s.data.sub_jj, &s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
      for (Complex& weight : channel->weight) weight.imag(weight.real());
    }
  }
  const LineState state = nearby(s);
  const ComplexMatrix z = s.joint.at(s.theta);
  LineModel model(s.layout, circular ? LineModel::Numbers::complex : LineModel::Numbers::real);
  model.linearise(s.data, s.joint, z, state, true);
  const auto reduced = model.reduce(0.0);
  RC_PRE(reduced.has_value());
  RC_ASSERT(has_plain_errors(s.data));
  const LineGradient gradient = gradient_of(s.layout, s.data, s.joint, z, state);
  RC_ASSERT(std::abs(gradient.cost - line_cost(s.layout, s.data, z, state.sub_jn, state.sub_jj)) <= 1e-10 * gradient.cost);
  const double brings = gradient.own.dot(model.own_step(gradient.own));  // of χ²: steps that only weak rows fix count little
  RC_ASSERT(std::abs(gradient.own.dot(reduced->own) - brings) <= 1e-8 * brings);
  RC_ASSERT(std::abs(gradient.cost - reduced->cost - brings) <= 1e-8 * gradient.cost);
  const Eigen::VectorXd by_frfs = reduced->back->transpose_times(gradient.own);
  RC_ASSERT((gradient.joint - by_frfs - reduced->gradient).norm() <= 1e-8 * (gradient.joint.norm() + by_frfs.norm()));
}

/// The sample's FRFs at their best for a joint: Gauss–Newton to the end. Empty where it does not settle.
std::optional<LineState> settled(const LineSample& s, const std::vector<double>& theta) {
  LineState state = s.exact;
  LineModel model(s.layout);
  const ComplexMatrix z = s.joint.at(theta);
  for (int iteration = 0; iteration < 50; ++iteration) {
    put_on_constraint(s.layout, z, state);
    model.linearise(s.data, s.joint, z, state, false);
    const auto reduced = model.reduce(0.0);
    if (!reduced || !reduced->own.allFinite()) return std::nullopt;
    move(s.layout, reduced->own, 1.0, state.sub_jn, state.sub_jj);
    if (reduced->own.norm() < 1e-13) {
      put_on_constraint(s.layout, z, state);
      return state;
    }
  }
  return std::nullopt;
}

/// Of three systematic errors, each in about a third of the elements.
std::shared_ptr<const SystematicTerms> any_terms(LineSample& s) {
  auto out = std::make_shared<SystematicTerms>();
  out->unknowns = 3;
  out->first = {0};
  for (const Channel* channel : {&s.data.sub_jn, &s.data.sub_jj, &s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
    for (std::size_t i = 0; i < channel->value.size(); ++i) {
      for (std::size_t u = 0; u < out->unknowns; ++u) {
        if (s.normal() > 0.4) out->terms.push_back({u, 0.1 * s.any(), s.any(), 1.0});
      }
      out->first.push_back(out->terms.size());
    }
  }
  return out;
}

/// Circular errors: the complex equations are the real ones, as far as normal equations of their condition can tell; of
/// systematic errors, too, which real ones have beside plain rows.
RC_GTEST_PROP(LikelihoodLine, ComplexEquationsAreTheRealOnes, (unsigned seed, bool systematic)) {
  std::mt19937_64 random(seed);
  LineSample s(any_shape(random), random);
  if (systematic) s.data.terms = any_terms(s);
  for (Channel* channel : {&s.data.sub_jn, &s.data.sub_jj, &s.data.asm_jn, &s.data.asm_jj, &s.data.drop_nn}) {
    for (Complex& weight : channel->weight) weight.imag(weight.real());
  }
  const LineState state = nearby(s);
  const Eigen::MatrixXd rows = equations(s, state, -jacobian(s, state));
  Eigen::MatrixXd of_frfs = rows.leftCols(at(2 * s.layout.variables()));
  of_frfs.array().rowwise() /= of_frfs.colwise().norm().array().eval();
  const Eigen::VectorXd stretch = dense::svd(of_frfs, dense::Vectors::none, dense::Vectors::none).sigma;
  const double tolerance = 1e-12 + 1e-14 * std::pow(stretch[0] / stretch[stretch.size() - 1], 2);
  RC_PRE(tolerance < 1e-4);
  const double cancelled = 1e-3 + rows.squaredNorm();
  LineModel real(s.layout, LineModel::Numbers::real), complex(s.layout, LineModel::Numbers::complex);
  for (const bool with_joint : {true, false}) {
    for (LineModel* model : {&real, &complex}) model->linearise(s.data, s.joint, s.joint.at(s.theta), state, with_joint);
    for (const double damping : {0.0, 0.1}) {
      const auto one = real.reduce(damping), other = complex.reduce(damping);
      RC_ASSERT(one.has_value() && other.has_value());
      expect_close(other->information, one->information, tolerance, cancelled);
      expect_close(other->gradient, one->gradient, tolerance, cancelled);
      expect_close(other->back->matrix(), one->back->matrix(), tolerance);
      expect_close(other->own, one->own, tolerance);
      RC_ASSERT(std::abs(other->cost - one->cost) <= tolerance * (cancelled + one->cost));
    }
  }
}

/// The cost with the FRFs at their best falls along θ by twice the reduced gradient (variable projection).
RC_GTEST_PROP(LikelihoodLine, GradientIsThatOfTheMinimisedCost, (unsigned seed)) {
  constexpr double h = 1e-5;
  std::mt19937_64 random(seed);
  LineShape shape = any_shape(random);
  shape.noise = 1e-3;
  shape.missing = 0.0;
  LineSample s(shape, random);
  const auto best = settled(s, s.theta);
  RC_PRE(best.has_value());
  LineModel model(s.layout);
  model.linearise(s.data, s.joint, s.joint.at(s.theta), *best, true);
  const auto reduced = model.reduce(0.0);
  for (std::size_t t = 0; t < s.theta.size(); ++t) {
    std::array<double, 2> cost{};
    for (const int side : {0, 1}) {
      std::vector<double> theta = s.theta;
      theta[t] += side == 0 ? -h : h;
      const auto state = settled(s, theta);
      RC_PRE(state.has_value());
      cost[static_cast<std::size_t>(side)] = line_cost(s.layout, s.data, s.joint.at(theta), state->sub_jn, state->sub_jj);
    }
    const double slope = (cost[1] - cost[0]) / (2.0 * h), scale = std::sqrt(reduced->information(at(t), at(t)));
    RC_ASSERT(std::abs(slope + 2.0 * reduced->gradient[at(t)]) <= 1e-3 * (std::abs(slope) + scale));
  }
}

}  // namespace
}  // namespace jointid::ident
