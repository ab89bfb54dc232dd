#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "dense_gauss_helmert.hpp"
#include "ident/eigen_index.hpp"
#include "ident/likelihood/line_model.hpp"

namespace jointid::ident {
namespace {

void compare(const LineShape& shape, double tolerance, std::mt19937_64& random) {
  LineSample s(shape, random);
  LineState state = s.exact;
  LineStep step(at(2 * s.layout.variables()));
  for (double& value : step) value = s.normal();
  move(s.layout, step, 0.05, state.x, state.y);
  state.a += 0.05 * s.any(state.a);
  if (shape.with_b) state.b += 0.05 * s.any(state.b);
  const ComplexMatrix shifted = ComplexMatrix::Identity(state.y.rows(), state.y.cols()) + state.y * s.joint.at(s.theta);
  RC_PRE(shifted.inverse().norm() < 30.0);  // near a resonance of the assembly both routes lose that many digits, twice
  LineModel model(s.layout);
  model.linearise(s.data, s.joint, s.joint.at(s.theta), state, true);
  const auto reduced = model.reduce(0.0);
  RC_PRE(reduced && reduced->own.norm() < 10.0 && reduced->back.norm() < 100.0);  // the rest of the line fixes what is not measured
  const Eigen::LDLT<Eigen::MatrixXd> factors(reduced->information);
  RC_PRE(factors.rcond() > 1e-6);
  const DenseStep dense(s, state);
  const Eigen::VectorXd theta = factors.solve(reduced->gradient);
  RC_ASSERT((reduced->information - dense.information).norm() <= tolerance * dense.information.norm());
  RC_ASSERT((reduced->gradient - dense.gradient).norm() <= tolerance * dense.gradient.norm());
  RC_ASSERT((theta - dense.step).norm() <= tolerance * dense.step.norm() / factors.rcond());
  const LineStep frfs = reduced->own - reduced->back * theta;
  RC_ASSERT((frfs - dense.frf_step).norm() <= tolerance * dense.frf_step.norm() / factors.rcond());
}

RC_GTEST_PROP(LikelihoodLine, StepIsThatOfGaussHelmert, (unsigned seed, bool with_b, bool uncoupled)) {
  std::mt19937_64 random(seed);
  const auto n = *rc::gen::inRange<std::size_t>(4, 7), joint = *rc::gen::inRange<std::size_t>(1, 4);
  compare({.others = n, .joint = joint, .with_b = with_b, .uncoupled = uncoupled}, 1e-7, random);
}

RC_GTEST_PROP(LikelihoodLine, StepIsThatOfGaussHelmertWithUnmeasuredFrfs, (unsigned seed, bool with_b)) {
  std::mt19937_64 random(seed);
  // Normal equations of a line, in which what was not measured weighs 10⁻⁹ of the rest or less.
  compare({.others = 6, .joint = 2, .with_b = with_b, .missing = 0.1}, 1e-5, random);
}

}  // namespace
}  // namespace jointid::ident
