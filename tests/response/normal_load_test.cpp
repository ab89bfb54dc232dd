#include "response/time/normal_load.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "friction/law/laws.hpp"
#include "response/time/algorithm_one.hpp"
#include "response/time/transient.hpp"

/// Algorithms One and Two under a changing normal load, and Newmark's direct iteration.
namespace jointid::response {
namespace {

constexpr double mass = 1.0, damping = 2.0, stiffness = 1e4, omega = 80.0, level = 5.0;
constexpr double slip = 1e-4, joint_stiffness = 3e4;

JointedStructure oscillator(double k = joint_stiffness) {
  const auto one = [](double value) { return Eigen::MatrixXd::Constant(1, 1, value); };
  const std::vector<double> values = {slip * joint_stiffness / k, k};
  return {{one(mass), one(damping), one(stiffness)}, one(1.0), {friction::make_element("bilinear", values)}};
}

ForceHistory sine() { return ForceHistory::periodic(omega, {1}, Eigen::MatrixXcd::Constant(1, 1, Complex(0.0, -level))); }

/// A load between 0.2 and 1.8 of the nominal one, and a lift-off.
NormalLoad load() { return {.times = {0.0, 0.01, 0.03, 0.05}, .shares = {1.0, 1.8, -0.3, 1.0}, .period = 0.05, .sliders = 1}; }

double share_at(double t) {
  const double s = std::fmod(t, 0.05);
  if (s < 0.01) return 1.0 + 80.0 * s;
  return s < 0.03 ? 1.8 - 105.0 * (s - 0.01) : -0.3 + 65.0 * (s - 0.03);
}

/// The same by a symplectic Euler method of its own, one slider, in steps of 1e-7 s: x every 0.002 s.
std::vector<double> by_small_steps(double duration) {
  const double h = 1e-7;
  double x = 0.0, v = 0.0, f = 0.0;
  std::vector<double> told = {0.0};
  const auto steps = std::llround(duration / h), stride = std::llround(0.002 / h);
  for (long long i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) * h;
    v += h / mass * (level * std::sin(omega * (t - h)) - damping * v - stiffness * x - f);
    x += h * v;
    const double limit = std::max(0.0, share_at(t)) * joint_stiffness * slip;
    f = std::clamp(f + joint_stiffness * h * v, -limit, limit);
    if (i % stride == 0) told.push_back(x);
  }
  return told;
}

Transient marched(TransientMethod method, double delta, const std::vector<NormalLoad>& loads, double k = joint_stiffness) {
  return march_transient(oscillator(k), sine(),
                         {.duration = 0.3,
                          .step = 0.002,
                          .method = method,
                          .delta = delta,
                          .responses = Eigen::MatrixXd::Identity(1, 1),
                          .loads = loads});
}

double difference(const Transient& found, const std::vector<double>& expected) {
  double largest = 0.0, size = 0.0;
  for (Eigen::Index i = 0; i < found.x.rows(); ++i) {
    largest = std::max(largest, std::abs(found.x(i, 0) - expected[static_cast<std::size_t>(i)]));
    size = std::max(size, std::abs(expected[static_cast<std::size_t>(i)]));
  }
  return largest / size;
}

TEST(NormalLoad, IsStraightBetweenItsPointsAndComesAgain) {
  const NormalLoad periodic = load();
  for (const double t : {0.0, 0.004, 0.02, 0.049, 0.05, 0.171, 12.34}) EXPECT_NEAR(periodic.at(t), share_at(t), 1e-9) << t;
  const NormalLoad once = {.times = {1.0, 2.0}, .shares = {1.0, 3.0}};
  EXPECT_EQ(once.at(0.0), 1.0);
  EXPECT_EQ(once.at(1.5), 2.0);
  EXPECT_EQ(once.at(9.0), 3.0);
}

TEST(NormalLoad, OfBothAlgorithmsMovesAsSmallStepsDo) {
  const std::vector<double> expected = by_small_steps(0.3);
  for (const TransientMethod method : {TransientMethod::algorithm_one, TransientMethod::algorithm_two}) {
    const Transient coarse = marched(method, 1e-4, {load()}), fine = marched(method, 1e-5, {load()});
    EXPECT_LT(difference(fine, expected), 5e-4);
    EXPECT_LT(difference(fine, expected), 0.3 * difference(coarse, expected));
    const Transient constant = marched(method, 1e-5, {});
    EXPECT_GT(difference(constant, expected), 0.05);  // the load matters
  }
}

/// A constant load of 1 is the law itself, and of one slider the bilinear one.
TEST(NormalLoad, OfOneIsTheLaw) {
  const NormalLoad unit = {.times = {0.0}, .shares = {1.0}, .sliders = 1};
  const Transient with = marched(TransientMethod::algorithm_one, 1e-4, {unit}),
                  without = marched(TransientMethod::algorithm_one, 1e-4, {});
  EXPECT_LT((with.x - without.x).cwiseAbs().maxCoeff(), 1e-12 * without.x.cwiseAbs().maxCoeff() + 1e-15);
  EXPECT_THROW(marched(TransientMethod::algorithm_one, 1e-4, {unit, unit}), InputError);
}

/// Of a joint that sticks at k the direct iteration has the factor kG, G = 1/(4m/Δ² + 2c/Δ + K): it converges where that is
/// below 1.
TEST(Newmark, DivergesWhereAlgorithmOneConverges) {
  for (const double k : {3e4, 1e6, 1e8}) {
    for (const double delta : {1e-3, 1e-4, 1e-5}) {
      const double factor = k / (4.0 * mass / (delta * delta) + 2.0 * damping / delta + stiffness);
      const Transient one = marched(TransientMethod::algorithm_one, delta, {}, k),
                      newmark = marched(TransientMethod::newmark, delta, {}, k);
      EXPECT_TRUE(one.complete) << k << " " << delta;
      EXPECT_EQ(newmark.complete, factor < 1.0) << k << " " << delta << " factor " << factor;
      if (!newmark.complete) continue;
      EXPECT_LT((newmark.x - one.x).cwiseAbs().maxCoeff(), 1e-6 * one.x.cwiseAbs().maxCoeff()) << k << " " << delta;
    }
  }
}

}  // namespace
}  // namespace jointid::response
