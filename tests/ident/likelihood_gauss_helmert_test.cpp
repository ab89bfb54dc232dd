#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/eigen.hpp"
#include "dense_gauss_helmert.hpp"
#include "ident/likelihood/line/line_model.hpp"

namespace jointid::ident {
namespace {

/// A line, and a state near its exact FRFs, from which both routes take their step.
struct Example {
  explicit Example(const LineShape& shape, std::mt19937_64& random)
      : sample(shape, random), z(sample.joint.at(sample.theta)), state(sample.exact) {
    LineStep step(at(2 * sample.layout.variables()));
    for (double& value : step) value = sample.normal();
    move(sample.layout, step, 0.05, state.x, state.y);
    state.a += 0.05 * sample.any(state.a);
    if (shape.with_b) state.b += 0.05 * sample.any(state.b);
  }

  ComplexMatrix coupled() const { return ComplexMatrix::Identity(z.rows(), z.cols()) + state.y * z; }

  /// Turns and stretches Y until I + YZ has the eigenvalue `distance`: a resonance of the assembly is that close.
  void approach_resonance(double distance) {
    const Eigen::VectorXcd eigenvalues = Eigen::ComplexEigenSolver<ComplexMatrix>(state.y * z, false).eigenvalues();
    Eigen::Index largest = 0;
    eigenvalues.cwiseAbs().maxCoeff(&largest);
    state.y *= (distance - 1.0) / eigenvalues[largest];
  }

  LineSample sample;
  ComplexMatrix z;
  LineState state;
};

/// (I + YZ)⁻¹ stands twice in every product that the elimination cancels: both routes lose its digits twice. One of
/// 70,000 random lines near a resonance had errors above a tenth of this.
double tolerance(const Example& example) { return 1e-9 * (1.0 + example.coupled().inverse().squaredNorm()); }

void compare(const Example& example) {
  const LineSample& s = example.sample;
  LineModel model(s.layout);
  model.linearise(s.data, s.joint, example.z, example.state, true);
  const auto reduced = model.reduce(0.0);
  RC_ASSERT(reduced.has_value());
  const Eigen::LDLT<Eigen::MatrixXd> factors(reduced->information);
  const DenseStep dense(s, example.state);
  const Eigen::VectorXd theta = factors.solve(reduced->gradient);
  const LineStep frfs = reduced->own - reduced->back * theta;
  const double of_sums = tolerance(example), of_steps = of_sums / factors.rcond();
  RC_ASSERT((reduced->information - dense.information).norm() <= of_sums * dense.information.norm());
  RC_ASSERT((reduced->gradient - dense.gradient).norm() <= of_sums * dense.gradient.norm());
  RC_ASSERT((theta - dense.step).norm() <= of_steps * dense.step.norm());
  RC_ASSERT((frfs - dense.frf_step).norm() <= of_steps * dense.frf_step.norm());
}

LineShape any_measured(bool with_b, bool uncoupled) {
  const auto others = *rc::gen::inRange<std::size_t>(4, 7), joint = *rc::gen::inRange<std::size_t>(1, 4);
  return {.others = others, .joint = joint, .with_b = with_b, .uncoupled = uncoupled};
}

/// What was not measured weighs 10⁻⁹ of the rest or less in the normal equations of a line.
LineShape partly_measured(bool with_b) { return {.others = 6, .joint = 2, .with_b = with_b, .missing = 0.1}; }

RC_GTEST_PROP(LikelihoodLine, StepIsThatOfGaussHelmert, (unsigned seed, bool with_b, bool uncoupled)) {
  std::mt19937_64 random(seed);
  compare(Example(any_measured(with_b, uncoupled), random));
}

RC_GTEST_PROP(LikelihoodLine, StepIsThatOfGaussHelmertWithUnmeasuredFrfs, (unsigned seed, bool with_b)) {
  std::mt19937_64 random(seed);
  compare(Example(partly_measured(with_b), random));
}

RC_GTEST_PROP(LikelihoodLine, NearAResonanceStepIsThatOfGaussHelmert,
              (unsigned seed, bool with_b, bool uncoupled, bool all_measured)) {
  std::mt19937_64 random(seed);
  Example example(all_measured ? any_measured(with_b, uncoupled) : partly_measured(with_b), random);
  const double distance = *rc::gen::element(1e-1, 1e-2, 1e-3);
  example.approach_resonance(distance);
  RC_ASSERT(example.coupled().inverse().norm() >= 0.99 / distance);
  compare(example);
}

}  // namespace
}  // namespace jointid::ident
