// The equations of a line solved by their structure against those of all rows, which likelihood_line_model_test.cpp holds to
// differences.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "base/eigen.hpp"
#include "ident/likelihood/elimination/elimination_flops.hpp"
#include "ident/likelihood/line/line_model.hpp"
#include "likelihood_line_sample.hpp"

namespace jointid::ident {
namespace {

/// Circular errors, of sizes that are apart by factors up to `ratio`.
void make_circular(LineSample& s, double ratio, std::mt19937_64& random) {
  std::uniform_real_distribution<double> power(-0.5, 0.5);
  for (Channel* channel : {&s.data.x, &s.data.y, &s.data.a, &s.data.b, &s.data.d}) {
    for (Complex& weight : channel->weight) weight = weight.real() * std::pow(ratio, power(random)) * Complex(1.0, 1.0);
  }
}

/// Some FRFs off, and A and B off the constraint unless asked for.
LineState moved(LineSample& s, bool on_constraint) {
  LineState state = s.exact;
  LineStep step(at(2 * s.layout.variables()));
  for (double& value : step) value = s.normal();
  move(s.layout, step, 0.05, state.x, state.y);
  put_on_constraint(s.layout, s.joint.at(s.theta), state);
  if (on_constraint) return state;
  state.a += 0.05 * s.any(state.a);
  if (!s.layout.b.empty()) state.b += 0.05 * s.any(state.b);
  return state;
}

double size_of(const Eigen::MatrixXd& a) { return a.size() == 0 ? 0.0 : a.cwiseAbs().maxCoeff(); }

void expect_same(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance, double size) {
  RC_ASSERT(a.rows() == b.rows() && a.cols() == b.cols());
  RC_ASSERT(size_of(a - b) <= tolerance * (size + size_of(b)));
}

/// A common factor of steps that the equations hardly fix is what normal equations of any kind cannot tell: twice the digits of
/// it are lost. It is seen from a step back.
void expect_same_reduction(const LineSample& s, LineModel& rows, LineModel& structure, const LineState& state, double tolerance) {
  for (const bool with_joint : {true, false}) {
    for (LineModel* model : {&rows, &structure}) model->linearise(s.data, s.joint, s.joint.at(s.theta), state, with_joint);
    for (const double damping : {0.0, 0.1, 0.0}) {
      const auto one = rows.reduce(damping), other = structure.reduce(damping);
      RC_ASSERT(one.has_value() && other.has_value());
      const double information = size_of(one->information), gradient = size_of(one->gradient);
      expect_same(other->information, one->information, tolerance, information);
      expect_same(other->gradient, one->gradient, tolerance, gradient + std::sqrt(information * one->cost));
      RC_ASSERT(std::abs(other->cost - one->cost) <= tolerance * one->cost);
      expect_same(*other->back, *one->back, tolerance, 0.0);
      expect_same(other->own, one->own, tolerance, 1.0);
      LineStep any(one->own.size());
      for (Eigen::Index i = 0; i < any.size(); ++i) any[i] = std::sin(static_cast<double>(i));
      expect_same(structure.own_step(any), rows.own_step(any), tolerance, 0.0);
    }
  }
}

RC_GTEST_PROP(LikelihoodElimination, SolvesTheEquationsOfAllRows, (unsigned seed)) {
  std::mt19937_64 random(seed);
  const auto up_to = [&](std::size_t most) { return std::uniform_int_distribution<std::size_t>(1, most)(random); };
  std::bernoulli_distribution coin;
  LineSample s({.others = up_to(6), .joint = up_to(6), .with_b = coin(random), .uncoupled = coin(random)}, random);
  make_circular(s, coin(random) ? 10.0 : 1.0, random);
  // Not all of A, B and D.
  std::bernoulli_distribution absent(coin(random) ? 0.2 : 0.0);
  for (Channel* channel : {&s.data.a, &s.data.b, &s.data.d}) {
    for (Complex& weight : channel->weight) weight = absent(random) ? Complex(0.0) : weight;
  }
  const LineState state = moved(s, coin(random));
  const double inverse = s.joint.at(s.theta).norm() * state.y.norm();
  RC_PRE(inverse < 30.0);
  LineModel rows(s.layout, LineModel::Numbers::complex), structure(s.layout, LineModel::Numbers::eliminated);
  expect_same_reduction(s, rows, structure, state, 1e-10);
}

/// Weights by a factor of 10⁴ apart.
RC_GTEST_PROP(LikelihoodElimination, KeepsDigitsWithErrorsOfAllSizes, (unsigned seed)) {
  std::mt19937_64 random(seed);
  LineSample s({.others = 4, .joint = 4, .with_b = true, .uncoupled = true}, random);
  make_circular(s, 1e4, random);
  const LineState state = moved(s, true);
  RC_PRE(s.joint.at(s.theta).norm() * state.y.norm() < 30.0);
  LineModel rows(s.layout, LineModel::Numbers::complex), structure(s.layout, LineModel::Numbers::eliminated);
  expect_same_reduction(s, rows, structure, state, 1e-6);
}

}  // namespace
}  // namespace jointid::ident
