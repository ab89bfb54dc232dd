#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "dense/lu.hpp"
#include "dense/svd.hpp"
#include "dense_gauss_helmert.hpp"
#include "ident/likelihood/model/line_model.hpp"

namespace jointid::ident {
namespace {

/// A line, and a state near its exact FRFs, from which both routes take their step.
struct Example {
  explicit Example(const LineShape& shape, std::mt19937_64& random)
      : sample(shape, random), z(sample.joint.at(sample.theta)), state(sample.exact) {
    LineStep step(at(2 * sample.layout.variables()));
    for (double& value : step) value = sample.normal();
    move(sample.layout, step, 0.05, state.sub_jn, state.sub_jj);
    state.asm_jn += 0.05 * sample.any(state.asm_jn);
    if (shape.with_b) state.asm_jj += 0.05 * sample.any(state.asm_jj);
  }

  ComplexMatrix coupled() const { return ComplexMatrix::Identity(z.rows(), z.cols()) + state.sub_jj * z; }

  /// Turns and stretches Y until I + YZ has the eigenvalue `distance`: a resonance of the assembly is that close.
  void approach_resonance(double distance) { state.sub_jj *= (distance - 1.0) / largest_eigenvalue(state.sub_jj * z); }

  /// Of the real matrix [Re −Im; Im Re], which has those of the complex one and their conjugates.
  static Complex largest_eigenvalue(const ComplexMatrix& a) {
    Eigen::MatrixXd real(2 * a.rows(), 2 * a.rows());
    real << a.real(), -a.imag(), a.imag(), a.real();
    const Eigen::VectorXcd eigenvalues = dense::eigenvalues(real);
    Eigen::Index largest = 0;
    eigenvalues.cwiseAbs().maxCoeff(&largest);
    const auto least_singular_value = [&a](Complex value) {
      const ComplexMatrix shifted = a - value * ComplexMatrix::Identity(a.rows(), a.rows());
      return dense::svd(shifted, dense::Vectors::none, dense::Vectors::none).sigma[a.rows() - 1];
    };
    const Complex value = eigenvalues[largest], other = std::conj(value);
    return least_singular_value(value) < least_singular_value(other) ? value : other;
  }

  LineSample sample;
  ComplexMatrix z;
  LineState state;
};

/// (I + YZ)⁻¹ stands twice in every product that the elimination cancels: both routes lose its digits twice. One of
/// 70,000 random lines near a resonance had errors above a tenth of this.
double tolerance(const Example& example) { return 1e-9 * (1.0 + dense::inverse(example.coupled()).squaredNorm()); }

void compare(const Example& example) {
  const LineSample& s = example.sample;
  LineModel model(s.layout);
  model.linearise(s.data, s.joint, example.z, example.state, true);
  const auto reduced = model.reduce(0.0);
  RC_ASSERT(reduced.has_value());
  const auto solved = dense::solve_definite(reduced->information, reduced->gradient);
  RC_ASSERT(solved.has_value());
  const DenseStep dense(s, example.state);
  const Eigen::VectorXd& theta = solved->x;
  const LineStep frfs = reduced->own + reduced->answer(theta);
  const double of_sums = tolerance(example), of_steps = of_sums / solved->reciprocal_condition;
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
  RC_ASSERT(dense::inverse(example.coupled()).norm() >= 0.99 / distance);
  compare(example);
}

}  // namespace
}  // namespace jointid::ident
