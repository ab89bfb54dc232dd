#include "virtualpoint/consistency.hpp"

#include <gmock/gmock.h>

#include "frf/noise/noise.hpp"
#include "interface.hpp"

namespace jointid::virtualpoint {
namespace {

Consistency of(const frf::FrfSet& set, const VirtualPoint& point) {
  const auto source = frf::from_memory(set);
  const std::vector<std::size_t> lines = {0, 1, 2, 3, 4};
  return consistency(*source, point, lines);
}

frf::FrfSet noisy(const Interface& in, std::uint64_t seed) {
  return frf::polluted(in.set, {.kind = frf::NoiseKind::circular, .level = 0.01, .reciprocal = false}, seed, 0, 0);
}

TEST(Consistency, OfARigidInterfaceIsOne) {
  const Interface in(1);
  const Consistency out = of(in.set, in.point);
  EXPECT_EQ(out.frequency_hz.size(), Interface::lines);
  for (const SideConsistency* side : {&out.sensors, &out.impacts}) {
    for (const double value : side->specific) EXPECT_NEAR(value, 1.0, 1e-12);
    for (const double value : side->overall) EXPECT_NEAR(value, 1.0, 1e-12);
  }
  for (const double value : out.rigidity) EXPECT_NEAR(value, 1.0, 1e-12);
  EXPECT_TRUE(out.wrong.empty());
}

/// The definitions, written out for FRFs of no rigid interface.
TEST(Consistency, IsThatOfItsDefinition) {
  Interface in(2);
  for (Complex& value : in.set.values) value += 0.5 * Complex(in.number(), in.number());
  const Consistency out = of(in.set, in.point);
  const Eigen::MatrixXd ru = in.sensor_rows(), rf = in.impact_rows();
  const Eigen::MatrixXcd fu = (ru * weighted_inverse(ru, Eigen::VectorXd::Ones(12))).cast<Complex>();
  const Eigen::MatrixXcd ff = (rf * weighted_inverse(rf, Eigen::VectorXd::Ones(9))).cast<Complex>();
  std::vector<double> specific(12, 0.0);
  for (std::size_t line = 0; line < Interface::lines; ++line) {
    const Eigen::MatrixXcd y = in.line(line);
    const Eigen::VectorXcd u = y * Eigen::VectorXcd::Ones(9), filtered = fu * u;
    EXPECT_NEAR(out.sensors.overall[line], filtered.norm() / u.norm(), 1e-12);
    const Eigen::RowVectorXcd f = Eigen::RowVectorXcd::Ones(12) * y;
    EXPECT_NEAR(out.impacts.overall[line], (f * ff).norm() / f.norm(), 1e-12);
    EXPECT_NEAR(out.rigidity[line], (fu * y * ff).norm() / y.norm(), 1e-12);
    for (Eigen::Index i = 0; i < 12; ++i) {
      specific[static_cast<std::size_t>(i)] +=
          std::norm(u[i] + filtered[i]) / (2.0 * (std::norm(u[i]) + std::norm(filtered[i]))) / double{Interface::lines};
    }
  }
  for (std::size_t i = 0; i < 12; ++i) EXPECT_NEAR(out.sensors.specific[i], specific[i], 1e-12);
}

TEST(Consistency, FindsASensorOfAnotherDirection) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Interface in(seed);
    VirtualPoint wrong = in.point;
    const Vector stated = {0.0, 0.6, 0.8};
    wrong.sensors[5].direction = stated;  // really ±z
    const Consistency out = of(noisy(in, seed), wrong);
    ASSERT_EQ(out.wrong.size(), 1U) << seed;
    EXPECT_EQ(out.wrong[0].side, Side::sensors);
    EXPECT_EQ(out.wrong[0].dof, in.point.sensors[5].dof);
    EXPECT_EQ(out.wrong[0].stated, stated);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(out.wrong[0].found[k], k == 2 ? in.point.sensors[5].dof.sign : 0.0, 0.05) << seed;
  }
}

TEST(Consistency, FindsASensorAndAnImpactOfTheWrongSign) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Interface in(seed, 4, 18);
    VirtualPoint wrong = in.point;  // but for a sensor's cable
    for (std::size_t line = 0; line < Interface::lines; ++line) {
      for (std::size_t c = 0; c < 18; ++c) in.set.values[in.set.index(line, 7, c)] *= -1.0;
    }
    for (double& number : *wrong.impacts[4].direction) number = -number;
    const Consistency out = of(noisy(in, seed), wrong);
    ASSERT_EQ(out.wrong.size(), 2U) << seed;
    EXPECT_EQ(out.wrong[0].dof, wrong.sensors[7].dof);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(out.wrong[0].found[k], -out.wrong[0].stated[k], 0.1) << seed;
    EXPECT_EQ(out.wrong[1].side, Side::impacts);
    EXPECT_EQ(out.wrong[1].dof, wrong.impacts[4].dof);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(out.wrong[1].found[k], -out.wrong[1].stated[k], 0.1) << seed;
  }
}

TEST(Consistency, NoiseAloneMakesNoDirectionWrong) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Interface in(seed);
    EXPECT_TRUE(of(noisy(in, seed), in.point).wrong.empty()) << seed;
  }
}

TEST(Consistency, LeavesOutLinesThatWereNotMeasured) {
  Interface in(3);
  in.set.values[in.set.index(2, 1, 1)] = std::numeric_limits<double>::quiet_NaN();
  const Consistency out = of(in.set, in.point);
  EXPECT_THAT(out.frequency_hz, testing::ElementsAre(10.0, 20.0, 40.0, 50.0));
  EXPECT_EQ(out.rigidity.size(), 4U);
}

}  // namespace
}  // namespace jointid::virtualpoint
