#include "ident/likelihood/fit/secant_steps.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Core>
#include <random>

#include "dense/real_lu.hpp"

namespace jointid::ident {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Problem {
  std::mt19937_64 random;
  Eigen::Index size;
  MatrixXd information, hessian;

  explicit Problem(unsigned seed) : random(seed), size(std::uniform_int_distribution<Eigen::Index>(1, 6)(random)) {
    const MatrixXd root = any(size, size);
    information = root.transpose() * root + MatrixXd::Identity(size, size);
    const MatrixXd more = any(size, size);
    hessian = information + 0.3 * more.transpose() * more;
  }

  MatrixXd any(Eigen::Index rows, Eigen::Index columns) {
    std::normal_distribution<double> normal;
    return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
  }
  VectorXd any() { return any(size, 1); }
};

RC_GTEST_PROP(SecantSteps, AreGaussNewtonStepsWithoutThePast, (unsigned seed)) {
  Problem problem(seed);
  const VectorXd gradient = problem.any();
  const VectorXd expected = dense::RealLu(problem.information).solve(gradient);
  RC_ASSERT((SecantSteps().step(problem.information, gradient) - expected).norm() <= 1e-10 * expected.norm());
}

/// H y = s for the last step, H symmetric.
RC_GTEST_PROP(SecantSteps, RepeatTheLastStepForItsGradient, (unsigned seed)) {
  Problem problem(seed);
  SecantSteps steps;
  VectorXd step;
  for (int k = 0; k < 12; ++k) {
    step = problem.any();
    steps.note(step, problem.hessian * step, problem.information);
  }
  RC_PRE(step.dot(problem.hessian * step) < 10.0 * step.dot(problem.information * step));
  RC_ASSERT((steps.step(problem.information, problem.hessian * step) - step).norm() <= 1e-8 * step.norm());
  const VectorXd a = problem.any(), b = problem.any();
  const double left = a.dot(steps.step(problem.information, b)), right = b.dot(steps.step(problem.information, a));
  RC_ASSERT(std::abs(left - right) <= 1e-8 * a.norm() * b.norm() * (1.0 + std::abs(left)));
}

RC_GTEST_PROP(SecantSteps, LeaveOutGradientsThatFallAgainstTheCurvature, (unsigned seed)) {
  Problem problem(seed);
  SecantSteps steps;
  const VectorXd step = problem.any(), gradient = problem.any();
  steps.note(step, -problem.hessian * step, problem.information);
  steps.note(step, 100.0 * problem.hessian * step, problem.information);
  RC_ASSERT(steps.step(problem.information, gradient) == SecantSteps().step(problem.information, gradient));
}

/// On a quadratic function whose Hessian is not the information they arrive where Gauss–Newton steps still shrink at a constant rate.
RC_GTEST_PROP(SecantSteps, EndSoonerThanGaussNewton, (unsigned seed)) {
  Problem problem(seed);
  const VectorXd start = problem.any();
  const auto left = [&](bool secant) {
    SecantSteps steps;
    VectorXd x = start;
    for (Eigen::Index k = 0; k < 4 * problem.size; ++k) {
      const VectorXd gradient = -(problem.hessian * x);
      if (gradient.norm() < 1e-13 * start.norm()) break;
      const VectorXd step = steps.step(problem.information, gradient);
      x += step;
      if (secant) steps.note(step, problem.hessian * step, problem.information);
    }
    return x.norm();
  };
  RC_ASSERT(left(true) <= left(false) + 1e-12 * start.norm());
}

}  // namespace
}  // namespace jointid::ident
