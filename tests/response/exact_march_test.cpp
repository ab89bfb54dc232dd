#include "response/time/exact_march.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "friction/path/parallel.hpp"
#include "golden_motions.hpp"
#include "tests/response/any_joint.hpp"

namespace jointid::response {
namespace {

using Eigen::VectorXd;
using nlohmann::json;

Eigen::VectorXd first(Eigen::Index size, double value) { return value * VectorXd::Unit(size, 0); }

ForceHistory force_of(const json& one) {
  const Eigen::Index size = matrix(one.at("M")).rows();
  const double p = one.at("p");
  if (one.contains("td")) return ForceHistory::half_sine(first(size, 2.0 * p), one.at("td"));
  return ForceHistory::periodic(one.at("omega"), {1}, Complex(0.0, -1.0) * first(size, p));
}

TEST(ExactMarch, MeetsTheGoldenTransients) {
  for_each_golden("transient_exact", [](const json& one) {
    SCOPED_TRACE(one.at("id").get<std::string>());
    ExactMarch march(jointed(one), force_of(one));
    const auto& times = one.at("times");
    Eigen::MatrixXd x(times.size(), 3), v(times.size(), 3);
    for (std::size_t i = 0; i < times.size(); ++i) {
      ASSERT_TRUE(march.march(times[i]));
      x.row(at(i)) = march.motion().x;
      v.row(at(i)) = march.motion().v;
    }
    EXPECT_LT(difference(x, matrix(one.at("x"))), tolerance(one));
    EXPECT_LT(difference(v, matrix(one.at("v"))), tolerance(one));
    if (one.contains("joint_at_end")) {
      const VectorXd q = matrix(one.at("W")).transpose() * march.motion().x;
      EXPECT_LT(difference(q, vector(one.at("joint_at_end").at("q"))), 10.0 * tolerance(one));
      EXPECT_LT(difference(march.motion().f, vector(one.at("joint_at_end").at("F"))), 10.0 * tolerance(one));
    }
  });
}

TEST(ExactMarch, MeetsTheTransientsOfTheThesis) {
  for_each_golden("thesis_18dof", [](const json& one) {
    for (const std::string type : {"B", "E"}) {
      SCOPED_TRACE(type);
      JointedStructure structure = jointed(one);
      structure.laws = {golden::element(one.at("joint_types").at(type)), golden::element(one.at("joint_types").at(type))};
      const Eigen::VectorXcd amplitude = Complex(0.0, -1.0) * VectorXd::Unit(structure.coordinates(), 4);
      ExactMarch march(structure, ForceHistory::periodic(one.at("omega"), {1}, amplitude));
      const json& expected = one.at("type_" + type).at("transient");
      const Eigen::MatrixXd rows = matrix(expected.at(type == "B" ? "x5_x7_f2" : "x5_x7"));
      Eigen::MatrixXd found(rows.rows(), rows.cols());
      for (std::size_t i = 0; i < expected.at("times").size(); ++i) {
        ASSERT_TRUE(march.march(expected.at("times")[i]));
        const Instant motion = march.motion();
        found(at(i), 0) = motion.x[4];
        found(at(i), 1) = motion.x[6];
        if (rows.cols() == 3) found(at(i), 2) = motion.f[1];
      }
      for (Eigen::Index k = 0; k < rows.cols(); ++k) EXPECT_LT(difference(found.col(k), rows.col(k)), 1e-9);
      if (!expected.contains("x5_max_to_0p2s")) continue;
      double largest = 0.0;
      ExactMarch again(structure, ForceHistory::periodic(one.at("omega"), {1}, amplitude));
      ASSERT_TRUE(again.march(0.2, [&](const MarchStep& step) {
        for (int i = 0; i < 50; ++i) largest = std::max(largest, std::abs(step.motion(i / 50.0).x[4]));
      }));
      const double sampled = expected.at("x5_max_to_0p2s");  // at some times, so a little less
      EXPECT_GE(largest, sampled);
      EXPECT_LT(largest, sampled * (1.0 + 1e-4));
    }
  });
}

JointedStructure three_masses(std::vector<std::shared_ptr<const friction::Element>> laws) {
  JointedStructure structure;
  structure.matrices.mass = Eigen::Vector3d(1.0, 1.2, 0.9).asDiagonal();
  structure.matrices.damping = (Eigen::Matrix3d() << 0.5, -0.16, 0.0, -0.16, 0.32, -0.04, 0.0, -0.04, 0.21).finished();
  structure.matrices.stiffness = (Eigen::Matrix3d() << 500.0, -200.0, 0.0, -200.0, 250.0, -50.0, 0.0, -50.0, 150.0).finished();
  structure.incidence = (Eigen::MatrixXd(3, 2) << 0.0, 0.0, 1.0, 0.0, -1.0, 1.0).finished().leftCols(at(laws.size()));
  structure.laws = std::move(laws);
  return structure;
}

std::shared_ptr<const friction::Element> make(const std::string& name, std::vector<double> values) {
  return friction::make_element(name, values);
}

ForceHistory beating(double p) {
  Eigen::MatrixXcd amplitudes(3, 3);
  amplitudes << p, Complex(0.0, -p), 0.3 * p, 0.0, 0.0, 0.5 * p, 0.0, 0.0, 0.0;
  return ForceHistory::periodic(2.3, {1, 5, 8}, amplitudes);
}

// A Masing path with its corners and a slider with its force know nothing of each other.
TEST(ExactMarch, FindsTheSameByCornersAndBySliders) {
  const auto one = make("bilinear", {0.01, 150.0}), two = make("bilinear", {0.012, 80.0});
  for (const double p : {2.0, 9.0, 40.0}) {
    ExactMarch sliders(three_masses({one, two}), beating(p));
    ExactMarch corners(three_masses({std::make_shared<friction::Parallel>(friction::Parts{one}),
                                     std::make_shared<friction::Parallel>(friction::Parts{two})}),
                       beating(p));
    ASSERT_TRUE(sliders.march(6.0));
    ASSERT_TRUE(corners.march(6.0));
    EXPECT_LT(difference(corners.motion().x, sliders.motion().x), 1e-11);
    EXPECT_LT(difference(corners.motion().f, sliders.motion().f), 1e-11);
  }
}

RC_GTEST_PROP(ExactMarch, OfAnyLawsAgreesWithShorterSteps, ()) {
  const std::vector<std::shared_ptr<const friction::Element>> laws = {any_joint(), any_joint()};
  const ForceHistory force = beating(any_in(1.0, 30.0));
  ExactMarch march(three_masses(laws), force), finer(three_masses(laws), force, {.longest_step = 0.02, .mismatch = 1e-11});
  RC_ASSERT(march.march(0.7));
  RC_ASSERT(finer.march(0.7));
  RC_ASSERT(difference(march.motion().x, finer.motion().x) < 1e-9);
  RC_ASSERT(difference(march.motion().f, finer.motion().f) < 1e-8);
}

TEST(ExactMarch, OfAStructureWithoutJointsIsTheLinearMotion) {
  JointedStructure single;
  single.matrices = {matrix(2.0), matrix(0.0), matrix(8.0)};
  single.incidence.resize(1, 0);
  ExactMarch march(single, ForceHistory::periodic(1.0, {0}, Eigen::MatrixXcd::Constant(1, 1, 3.0)));
  ASSERT_TRUE(march.march(5.0));
  EXPECT_NEAR(march.motion().x[0], 3.0 / 8.0 * (1.0 - std::cos(10.0)), 1e-14);
}

TEST(ExactMarch, TakesForcesFromSamples) {
  // A ramp that ends: x = (t − sin(ωt)/ω)/k up to 1, then what two ramps make.
  JointedStructure single;
  single.matrices = {matrix(1.0), matrix(0.0), matrix(9.0)};
  single.incidence.resize(1, 0);
  const ForceHistory ramp = ForceHistory::sampled(Eigen::MatrixXd::Ones(1, 1), {0.5, 1.5, 2.0}, Eigen::Vector3d(0.0, 1.0, 1.0));
  EXPECT_DOUBLE_EQ(ramp.value(1.0)[0], 0.5);
  EXPECT_DOUBLE_EQ(ramp.value(2.5)[0], 0.0);
  ExactMarch march(single, ramp);
  ASSERT_TRUE(march.march(1.9));
  const auto answer = [](double t) { return (t - std::sin(3.0 * t) / 3.0) / 9.0; };
  EXPECT_NEAR(march.motion().x[0], answer(1.4) - answer(0.4), 1e-15);
}

TEST(ExactMarch, SensitivitiesGoThroughEventsAsDifferencesDo) {
  const std::vector<std::shared_ptr<const friction::Element>> laws = {make("bilinear", {0.01, 150.0}),
                                                                      make("ren", {0.004, 1.5, 80.0})};
  ExactMarch march(three_masses(laws), beating(9.0));
  march.follow(Eigen::MatrixXd::Identity(8, 7));  // x, v, f of the slider
  march.march(3.0);
  ASSERT_GT(march.events(), 20U);
  for (Eigen::Index i = 0; i < 7; ++i) {
    Instant sides[2];
    const double h = i == 6 ? 1e-5 : 1e-6;
    for (const int side : {0, 1}) {
      ExactMarch other(three_masses(laws), beating(9.0));
      VectorXd state = VectorXd::Zero(8);
      state[i] = side == 0 ? h : -h;
      other.place(0.0, state.head(3), state.segment(3, 3), state.tail(2));
      other.march(3.0);
      sides[side] = other.motion();
    }
    const VectorXd x = (sides[0].x - sides[1].x) / (2.0 * h), v = (sides[0].v - sides[1].v) / (2.0 * h);
    EXPECT_LT((march.slopes().col(i).head(3) - x).cwiseAbs().maxCoeff(), 1e-6 * march.slopes().topRows(3).cwiseAbs().maxCoeff());
    EXPECT_LT((march.slopes().col(i).segment(3, 3) - v).cwiseAbs().maxCoeff(), 1e-6 * march.slopes().cwiseAbs().maxCoeff());
  }
}

TEST(ExactMarch, RefusesWhatDoesNotFit) {
  const JointedStructure good = three_masses({make("spring", {1.0})});
  JointedStructure massless = good, lawless = good;
  massless.matrices.mass(1, 1) = 0.0;
  lawless.laws.clear();
  EXPECT_THROW(ExactMarch(massless, beating(1.0)), InputError);
  EXPECT_THROW(ExactMarch(lawless, beating(1.0)), InputError);
  EXPECT_THROW(ExactMarch(good, ForceHistory::half_sine(VectorXd::Ones(2), 1.0)), InputError);
  EXPECT_THROW(ForceHistory::periodic(0.0, {1}, Eigen::MatrixXcd::Ones(3, 1)), InputError);
  EXPECT_THROW(ForceHistory::half_sine(VectorXd::Ones(3), -1.0), InputError);
  EXPECT_THROW(ForceHistory::sampled(Eigen::MatrixXd::Ones(3, 1), {0.0, 0.0}, Eigen::Vector2d(1.0, 2.0)), InputError);
}

}  // namespace
}  // namespace jointid::response
