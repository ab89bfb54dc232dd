#include "response/identify/direct_step.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "base/error.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "tests/require.hpp"
#include "tests/response/any_joint.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

/// H of the parts at the lines of a golden case, as numbers, with an error of each element if asked for.
class TabledReceptance final : public Receptance {
 public:
  TabledReceptance(const golden::json& of, double noise = 0.0) : noise_(noise) {
    for (std::size_t i = 0; i < of["harmonics"].size(); ++i) {
      const Eigen::MatrixXcd a = golden::complex_matrix(of["H_a"][i]), b = golden::complex_matrix(of["H_b"][i]);
      const Eigen::Index n = a.rows() + b.rows();
      Eigen::MatrixXcd h = Eigen::MatrixXcd::Zero(n, n);
      h.topLeftCorner(a.rows(), a.rows()) = a;
      h.bottomRightCorner(b.rows(), b.rows()) = b;
      lines_.push_back(of["omega"].get<double>() * of["harmonics"][i].get<int>());
      left_ = Eigen::MatrixXd::Zero(n, n + 1);
      left_(a.rows() - 1, 0) = 1.0;
      left_(a.rows(), 0) = -1.0;
      left_.rightCols(n).setIdentity();
      h_.push_back(h);
    }
  }
  void disturb(std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    for (Eigen::MatrixXcd& h : h_) {
      h = h.unaryExpr([&](Complex v) {
        const double size = noise_ * std::abs(v);
        const double re = normal(generator), im = normal(generator);
        return v + size * Complex(re, im);
      });
    }
  }
  Eigen::Index joints() const override { return 1; }
  Eigen::Index responses() const override { return left_.cols() - 1; }
  Eigen::Index forces() const override { return 1; }
  bool covers(double omega) const override { return find(omega) < lines_.size(); }
  Eigen::MatrixXcd at(double omega) const override { return left_.transpose() * h_[find(omega)] * left_.leftCols(2); }
  std::optional<Eigen::MatrixXcd> derivative(double) const override { return std::nullopt; }
  std::vector<ReceptanceError> errors(double omega) const override {
    std::vector<ReceptanceError> all;
    if (noise_ == 0.0) return all;
    const Eigen::MatrixXcd& h = h_[find(omega)];
    for (Eigen::Index i = 0; i < h.rows(); ++i) {
      for (Eigen::Index j = 0; j < h.cols(); ++j) {
        const double variance = noise_ * noise_ * std::norm(h(i, j));
        all.push_back({left_.row(i).transpose() * left_.leftCols(2).row(j), Complex(variance, variance)});
      }
    }
    return all;
  }

 private:
  std::size_t find(double omega) const {
    std::size_t i = 0;
    while (i < lines_.size() && std::abs(lines_[i] - omega) > 1e-9) ++i;
    return i;
  }

  double noise_;
  std::vector<double> lines_;
  std::vector<Eigen::MatrixXcd> h_;
  Eigen::MatrixXd left_;  ///< joint, then all coordinates; its first two columns: joint, force on the first coordinate
};

MeasuredState golden_state(const golden::json& each) {
  MeasuredState state;
  state.omega = each["omega"];
  state.force = Excitation::single(6.0);
  state.harmonics = golden::integers(each["harmonics"]);
  state.response = golden::complex_matrix(each["X"]);
  state.deviation = Eigen::MatrixXd::Constant(state.response.rows(), state.response.cols(), 1e-4);
  return state;
}

/// X is printed to 12 digits of its largest element, so F of harmonic n is known to that over |H_mW|.
TEST(DirectStep, ReturnsTheForcesOfTheGoldenCases) {
  const auto cases = golden::cases("receptance_coupling");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const DirectStep step = direct_step(TabledReceptance(each), golden_state(each));
    const double tolerance = golden::tolerance(each["trusted_digits"]);
    EXPECT_LE(golden::difference(step.joint_force.col(0), golden::complex_vector(each["F"])), tolerance) << each["id"];
    EXPECT_LE(golden::difference(step.joint_motion.col(0), golden::complex_vector(each["Q"])), tolerance) << each["id"];
    const Complex ratio = golden::complex(each["F"][0]) / golden::complex(each["Q"][0]);
    EXPECT_LE(std::abs(step.equivalent(0) - ratio), 10.0 * tolerance * std::abs(ratio)) << each["id"];
  }
}

/// Three masses with two joints, 2–3 and 3–ground, all coordinates measured.
std::shared_ptr<const Receptance> two_joints(const std::vector<Eigen::Index>& measured) {
  Eigen::MatrixXd m = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal(), k(3, 3), w(3, 2);
  k << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0;
  w << 0.0, 0.0, 1.0, 0.0, -1.0, 1.0;
  Eigen::MatrixXd seen = Eigen::MatrixXd::Zero(3, at(measured.size()));
  for (std::size_t i = 0; i < measured.size(); ++i) seen(measured[i], at(i)) = 1.0;
  return std::make_shared<MatrixReceptance>(MatrixStructure{m, 1e-3 * k, k}, w, seen, Eigen::MatrixXd::Identity(3, 1));
}

MeasuredState state_of(const HarmonicSolution& solution, const Excitation& force) {
  return {solution.omega, force, solution.harmonics, solution.response,
          Eigen::MatrixXd::Constant(solution.response.rows(), solution.response.cols(), 1e-4)};
}

/// H_mW of the higher harmonics is small and nearly singular: F is known to rounding times the condition.
RC_GTEST_PROP(DirectStep, ReturnsForcesAndMotionsOfHarmonicBalance, ()) {
  const auto structure = two_joints({0, 1, 2});
  const Excitation force = Excitation::single(std::polar(any_decade(1.0, 10.0), any_in(-3.0, 3.0)));
  const std::vector<Joint> joints = {{.name = "a", .friction = any_joint()}, {.name = "b", .friction = any_joint()}};
  const HarmonicSolution solution = HarmonicBalance(structure, joints, force, {.fixed = {1, 3, 5}}).solve(any_in(8.0, 25.0));
  RC_PRE(solution.converged);
  const DirectStep step = direct_step(*structure, state_of(solution, force));
  RC_ASSERT(golden::difference(step.joint_motion, solution.joint_motion) < 1e-12);
  RC_ASSERT(golden::difference(step.joint_force, solution.joint_force) < 1e-11);
  for (Eigen::Index j = 0; j < 2; ++j) {
    const Complex expected = solution.joint_force(0, j) / solution.joint_motion(0, j);
    RC_ASSERT(std::abs(step.equivalent(j) - expected) < 1e-9 * std::abs(expected));
  }
}

/// The means too: a steady force, even harmonics.
TEST(DirectStep, KnowsTheMean) {
  const auto structure = two_joints({0, 2});
  Excitation force = {{0, 1}, Eigen::MatrixXcd(2, 1)};
  force.amplitudes << 1.5, Complex(2.0, 4.0);
  const auto joint = [](double slip) {
    return Joint{.name = "joint", .friction = friction::make_element("bilinear", std::vector<double>{slip, 200.0})};
  };
  const HarmonicSolution solution =
      HarmonicBalance(structure, {joint(0.006), joint(0.004)}, force, {.fixed = {0, 1, 2, 3}}).solve(14.0);
  ASSERT_TRUE(solution.converged);
  const DirectStep step = direct_step(*structure, state_of(solution, force));
  EXPECT_LE(golden::difference(step.joint_motion, solution.joint_motion), 1e-12);
  EXPECT_LE(golden::difference(step.joint_force, solution.joint_force), 1e-11);
  EXPECT_EQ(step.force_deviation(0, 0).imag(), 0.0);
}

/// Coordinate 1 is free of joints, so its motion follows from that of 2: the two tell one force.
TEST(DirectStep, RefusesJointsThatTheResponsesDoNotTellApart) {
  const Excitation force = Excitation::single(3.0);
  const auto few = [&](const std::vector<Eigen::Index>& measured) {
    const Eigen::MatrixXcd response = Eigen::MatrixXcd::Constant(1, at(measured.size()), 0.01);
    return direct_step(*two_joints(measured), {14.0, force, {1}, response, Eigen::MatrixXd::Constant(1, response.cols(), 1e-4)});
  };
  EXPECT_NO_THROW(few({0, 2}));
  EXPECT_NO_THROW(few({1, 2}));
  EXPECT_THROW(few({0, 1}), InputError);
  EXPECT_THROW(few({1}), InputError);
  EXPECT_THROW(few({1, 1}), InputError);
}

/// Scatter over 400 draws, which tells a deviation to 3.5 %, of noise on responses and receptances.
TEST(DirectStep, DeviationsAreTheScatterOfRepeatedMeasurements) {
  const auto cases = golden::cases("receptance_coupling");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  const TabledReceptance structure(cases[0], 2e-3);
  MeasuredState state = golden_state(cases[0]);
  const DirectStep at = direct_step(structure, state);
  const Eigen::MatrixXcd exact = state.response;
  std::mt19937_64 generator(7);
  std::normal_distribution<double> normal;
  constexpr int draws = 400;
  double force = 0.0, motion = 0.0, stiffness = 0.0, damping = 0.0;
  for (int i = 0; i < draws; ++i) {
    TabledReceptance disturbed = structure;
    disturbed.disturb(generator);
    state.response = exact.unaryExpr([&](Complex v) {
      const double re = normal(generator), im = normal(generator);
      return v + 1e-4 * Complex(re, im);
    });
    const DirectStep drawn = direct_step(disturbed, state);
    force += std::pow((drawn.joint_force(0, 0) - at.joint_force(0, 0)).imag(), 2);
    motion += std::pow((drawn.joint_motion(0, 0) - at.joint_motion(0, 0)).real(), 2);
    stiffness += std::pow((drawn.equivalent(0) - at.equivalent(0)).real(), 2);
    damping += std::pow((drawn.equivalent(0) - at.equivalent(0)).imag(), 2);
  }
  EXPECT_NEAR(std::sqrt(force / draws) / at.force_deviation(0, 0).imag(), 1.0, 0.12);
  EXPECT_NEAR(std::sqrt(motion / draws) / at.motion_deviation(0, 0).real(), 1.0, 0.12);
  EXPECT_NEAR(std::sqrt(stiffness / draws) / at.equivalent_deviation(0).real(), 1.0, 0.12);
  EXPECT_NEAR(std::sqrt(damping / draws) / at.equivalent_deviation(0).imag(), 1.0, 0.12);
}

}  // namespace
}  // namespace jointid::response
