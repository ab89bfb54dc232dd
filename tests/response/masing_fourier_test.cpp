#include "response/fourier/masing_fourier.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "friction/path/masing_path.hpp"
#include "friction/path/path_energy.hpp"
#include "tests/friction/random_element.hpp"
#include "tests/require.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

TEST(MasingFourier, MeetsTheGoldenValues) {
  const auto cases = golden::cases("masing_fourier");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const Harmonics moved(golden::integers(each["harmonics_q"])), force(golden::integers(each["harmonics_F"]));
    const MasingFourier fourier(golden::element(each));
    const Motion motion(moved, golden::complex_vector(each["Q"]));
    const double tolerance = golden::tolerance(each["trusted_digits"]);
    const std::string id = each["id"];
    for (const bool parameters : {false, true}) {
      const ForceHarmonics found = fourier.evaluate(motion, force, parameters);
      EXPECT_LE(golden::difference(found.force, golden::complex_vector(each["F"])), tolerance) << id;
      EXPECT_LE(golden::difference(found.by_motion, golden::complex_matrix(each["dF_dq"])), tolerance) << id;
      EXPECT_EQ(found.reversals, each["reversals"].get<int>()) << id;
      if (parameters) {
        EXPECT_LE(golden::difference(found.by_parameters, golden::complex_matrix(each["dF_dparameters"])), tolerance) << id;
      }
    }
  }
}

/// A motion of the order of the element's slip displacement, with or without even harmonics and a mean.
Motion any_motion(const friction::Element& element) {
  const bool odd = friction::any_of(2) == 0;
  std::vector<int> numbers;
  for (int n = odd ? 1 : 0; n <= 6; n += odd ? 2 : 1) {
    if (n == 1 || friction::any_of(2) == 0) numbers.push_back(n);
  }
  const Harmonics harmonics(numbers);
  const double size = friction::any_displacement(element);
  Eigen::VectorXcd amplitudes(harmonics.size());
  for (Eigen::Index i = 0; i < harmonics.size(); ++i) {
    const double scale = size / std::max(1, harmonics[i]);
    amplitudes(i) = {scale * friction::any_in(-1.0, 1.0), scale * friction::any_in(-1.0, 1.0)};
  }
  return {harmonics, amplitudes};
}

/// F_n by the plain sum over equidistant samples of a Masing path that has run through a period from the largest |q|.
Eigen::VectorXcd sampled(const friction::Element& element, const Motion& motion, const Harmonics& force, int samples) {
  int first = 0;
  const auto q = [&](int i) { return motion.value(2.0 * std::numbers::pi * i / samples); };
  for (int i = 0; i < samples; ++i) {
    if (std::abs(q(i)) > std::abs(q(first))) first = i;
  }
  friction::MasingPath path(element);
  path.advance(q(first));
  Eigen::VectorXcd sum = Eigen::VectorXcd::Zero(force.size());
  for (int i = 1; i <= samples; ++i) {
    const double theta = 2.0 * std::numbers::pi * (first + i) / samples, f = path.advance(motion.value(theta)).force;
    for (Eigen::Index n = 0; n < force.size(); ++n) {
      sum(n) += (force[n] == 0 ? 1.0 : 2.0) * f * std::polar(1.0, -force[n] * theta) / static_cast<double>(samples);
    }
  }
  return sum;
}

RC_GTEST_PROP(MasingFourier, AgreesWithManySamplesOfAMasingPath, ()) {
  const auto element = std::shared_ptr<const friction::Element>(friction::any_element());
  const Motion motion = any_motion(*element);
  const Harmonics force({0, 1, 2, 3, 5, 8});
  const Eigen::VectorXcd expected = sampled(*element, motion, force, 4096);
  const Eigen::VectorXcd found = MasingFourier(element).evaluate(motion, force).force;
  RC_LOG() << friction::describe(*element);
  // Against the largest force that a joint without slip would have: what sampling misses is a share of that.
  const double size = element->response(0.0).tangent * motion.amplitudes().cwiseAbs().maxCoeff();
  RC_ASSERT((found - expected).cwiseAbs().maxCoeff() <= 1e-4 * std::max(size, 1e-300));
}

RC_GTEST_PROP(MasingFourier, LossIsThatOfThePath, ()) {
  const auto element = std::shared_ptr<const friction::Element>(friction::any_single());
  const Motion motion = any_motion(*element);
  const Harmonics& harmonics = motion.harmonics();
  const Eigen::VectorXcd force = MasingFourier(element).evaluate(motion, harmonics).force;
  double loss = 0.0;  // ∮ f q̇ = πΣ n Im(F_n conj Q_n)
  for (Eigen::Index i = 0; i < harmonics.size(); ++i) {
    loss += std::numbers::pi * harmonics[i] * std::imag(force(i) * std::conj(motion.amplitudes()(i)));
  }
  std::vector<double> turns = motion.reversals(0.1, 2.0 * std::numbers::pi);
  RC_PRE(!turns.empty());
  const auto largest = std::ranges::max_element(turns, {}, [&](double theta) { return std::abs(motion.value(theta)); });
  std::rotate(turns.begin(), largest, turns.end());
  friction::PathEnergy path(*element);
  path.advance(motion.value(turns.front()));
  const double before = path.loss();
  for (std::size_t i = 1; i <= turns.size(); ++i) path.advance(motion.value(turns[i % turns.size()]));
  const double q = motion.amplitudes().cwiseAbs().maxCoeff(), size = force.cwiseAbs().maxCoeff() * q;
  RC_LOG() << friction::describe(*element);
  RC_ASSERT(std::abs(loss - (path.loss() - before)) <= 1e-13 * size);
}

RC_GTEST_PROP(MasingFourier, DerivativesByMotionAreThoseOfDifferences, ()) {
  const auto element = std::shared_ptr<const friction::Element>(friction::any_element());
  const Motion motion = any_motion(*element);
  const Harmonics force({0, 1, 2, 3, 5});
  const MasingFourier fourier(element);
  const ForceHarmonics at = fourier.evaluate(motion, force);
  const double step = 1e-5 * motion.amplitudes().cwiseAbs().maxCoeff(), stiffness = element->response(0.0).tangent;
  RC_PRE(step > 0.0 && at.reversals > 0);
  Eigen::VectorXd unknowns = motion.harmonics().pack(motion.amplitudes());
  for (Eigen::Index u = 0; u < unknowns.size(); ++u) {
    const auto moved = [&](double by) {
      Eigen::VectorXd other = unknowns;
      other(u) += by;
      return fourier.evaluate({motion.harmonics(), motion.harmonics().unpack(other)}, force).force;
    };
    const Eigen::VectorXcd difference = (moved(step) - moved(-step)) / (2.0 * step);
    RC_LOG() << friction::describe(*element);
    RC_ASSERT((difference - at.by_motion.col(u)).cwiseAbs().maxCoeff() <= 5e-2 * stiffness);
  }
}

/// q(θ + δ): δQ_n = inQ_n δ must give δF_n = inF_n δ.
RC_GTEST_PROP(MasingFourier, ATimeShiftTurnsTheHarmonics, ()) {
  const auto element = std::shared_ptr<const friction::Element>(friction::any_single());
  const Motion motion = any_motion(*element);
  const Harmonics &moved = motion.harmonics(), force({0, 1, 2, 3, 5, 7});
  const ForceHarmonics at = MasingFourier(element).evaluate(motion, force);
  RC_PRE(at.reversals > 0);
  Eigen::VectorXcd turned = motion.amplitudes(), expected = at.force;
  for (Eigen::Index i = 0; i < turned.size(); ++i) turned(i) *= Complex(0.0, moved[i]);
  for (Eigen::Index i = 0; i < expected.size(); ++i) expected(i) *= Complex(0.0, force[i]);
  const double size = element->response(0.0).tangent * motion.amplitudes().cwiseAbs().maxCoeff();
  RC_LOG() << friction::describe(*element);
  RC_ASSERT((at.by_motion * moved.pack(turned).cast<Complex>() - expected).cwiseAbs().maxCoeff() <= 1e-11 * size);
}

TEST(MasingFourier, AJointAtRestMeetsItsInitialStiffness) {
  const MasingFourier fourier(friction::make_element("ren", std::vector{1e-6, 2.0, 1e7}));
  const Harmonics harmonics = Harmonics::all(2);
  const ForceHarmonics at = fourier.evaluate({harmonics, Eigen::VectorXcd::Zero(3)}, harmonics);
  EXPECT_EQ(at.reversals, 0);
  EXPECT_EQ(at.force.norm(), 0.0);
  EXPECT_EQ(at.by_motion(1, 1), Complex(1e7, 0.0));
  EXPECT_EQ(at.by_motion(1, 2), Complex(0.0, 1e7));
  EXPECT_EQ(at.by_motion(0, 0), Complex(1e7, 0.0));
}

}  // namespace
}  // namespace jointid::response
