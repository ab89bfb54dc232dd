#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/random.hpp"
#include "oscillation/measurement/friction_record.hpp"
#include "oscillation/measurement/phase.hpp"
#include "oscillation/measurement/strain.hpp"
#include "tests/oscillation/golden_series.hpp"
#include "tests/require.hpp"

namespace jointid::oscillation {
namespace {

void expect_matrix(const Eigen::MatrixXd& found, const nlohmann::json& expected, double tolerance) {
  ASSERT_EQ(found.rows(), static_cast<Eigen::Index>(expected.size()));
  for (Eigen::Index i = 0; i < found.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.cols(); ++j) {
      EXPECT_NEAR(found(i, j), expected[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].get<double>(), tolerance);
    }
  }
}

TEST(Strain, MapsMeetTheGoldenMatrices) {
  OSCILLATION_CASE(golden, "strain");
  const auto& input = golden["input"];
  const GaugedBeam beam{input["L"], input["h"], input["gauges"]};
  const std::vector<double> points = input["points"];
  const std::size_t modes = input["modes"];
  const StrainMap plain = strain_map(beam, beam_basis(modes, false), points);
  const StrainMap statics = strain_map(beam, beam_basis(modes, true), points);
  expect_matrix(plain.matrix, golden["expected"]["matrix"], 1e-8);
  expect_matrix(statics.matrix, golden["expected"]["matrix_with_static_shapes"], 1e-8);
  EXPECT_NEAR(plain.noise(3), 159.0, 1.0);
  EXPECT_NEAR(statics.noise(3) / plain.noise(3), 2.7, 0.1);

  // A static force at the nub, l beyond the tip: tip force F and moment Fl.
  const double l = 0.076;
  const auto nub = [&](double x) {
    const Deflection force = deflection({ShapeKind::tip_force, 0}, beam.length, x),
                     moment = deflection({ShapeKind::tip_moment, 0}, beam.length, x);
    return std::pair(force.value + l * moment.value, force.curvature + l * moment.curvature);
  };
  Eigen::VectorXd strain(static_cast<Eigen::Index>(beam.gauges.size()));
  for (std::size_t g = 0; g < beam.gauges.size(); ++g) strain(at(g)) = 0.5 * beam.thickness * nub(beam.gauges[g]).second;
  const Eigen::VectorXd y = plain.matrix * strain, exact = statics.matrix * strain;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const double truth = nub(points[p]).first;
    EXPECT_NEAR(y(at(p)) / truth - 1.0, golden["expected"]["bias_static_nub_force"][p].get<double>(), 1e-8);
    EXPECT_NEAR(exact(at(p)), truth, 1e-10 * std::abs(truth) * statics.condition);
  }
}

TEST(Strain, ShapesAreClampedFreeAndNormed) {
  for (std::size_t j = 1; j <= 20; ++j) {
    const Shape mode{ShapeKind::mode, j};
    const double length = 0.7, z = clamped_free_roots(20)[j - 1];
    EXPECT_NEAR(deflection(mode, length, 0.0).value, 0.0, 1e-14);
    EXPECT_NEAR(deflection(mode, length, length).value, j % 2 == 1 ? 2.0 : -2.0, 1e-10);
    EXPECT_NEAR(deflection(mode, length, length).curvature * length * length / (z * z), 0.0, 1e-10);
    for (const double x : {0.2, 0.55}) {
      const double e = 1e-5;
      const Deflection here = deflection(mode, length, x), up = deflection(mode, length, x + e),
                       down = deflection(mode, length, x - e);
      EXPECT_NEAR((up.value - down.value) / (2.0 * e), here.slope, 1e-6 * std::pow(z / length, 3));
      EXPECT_NEAR((up.slope - down.slope) / (2.0 * e), here.curvature, 1e-6 * std::pow(z / length, 4));
    }
    double square = 0.0;
    for (int i = 0; i < 4000; ++i) square += std::pow(deflection(mode, length, length * (i + 0.5) / 4000.0).value, 2) / 4000.0;
    EXPECT_NEAR(square, 1.0, 1e-3);
  }
}

TEST(Strain, WhatCannotBeToldIsSaid) {
  EXPECT_THROW(strain_map({0.4, 1e-3, {0.1, 0.2}}, beam_basis(3, false), {0.3}), InputError);
  EXPECT_THROW(strain_map({0.4, 1e-3, {0.1, 0.1, 0.1}}, beam_basis(3, false), {0.3}), InputError);
  EXPECT_THROW(strain_map({0.4, 1e-3, {0.1, 0.5}}, beam_basis(2, false), {0.3}), InputError);
  EXPECT_THROW(beam_basis(2, true), InputError);
}

/// Slips at speeds up to 1 with the law of the chain, sticks loaded to its limit.
TEST(FrictionRecord, FindsTheLawOfASimulatedRecord) {
  std::vector<double> velocity, force, normal;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const auto u = uniform_numbers({4, 0, 0}, i);
    const double noise = 0.004 * normal_numbers({5, 0, 0}, i)[0];
    const double load = 3.0 + u[2], sign = u[1] < 0.5 ? -1.0 : 1.0;
    const bool stick = u[3] < 0.3;
    velocity.push_back(stick ? 0.001 * (u[0] - 0.5) : sign * (0.01 + u[0]));
    force.push_back(load * (stick ? 0.5 * u[0] : sign * (0.3 + 0.2 * std::exp(-2.0 * std::abs(velocity.back())) + noise)));
    normal.push_back(load);
  }
  const FrictionLaw law = friction_law({velocity, force, normal}, {0.002, 0.0});
  ASSERT_TRUE(law.falls);
  EXPECT_NEAR(law.kinetic, 0.3, 4.0 * law.kinetic_error);
  EXPECT_NEAR(law.drop, 0.2, 4.0 * law.drop_error);
  EXPECT_NEAR(law.decay, 2.0, 4.0 * law.decay_error);
  EXPECT_NEAR(law.scatter, 0.004, 2e-4);
  EXPECT_LT(law.decay_error, 0.1);
  ASSERT_TRUE(law.static_bound);
  EXPECT_LE(*law.static_bound, 0.5);
  EXPECT_GT(*law.static_bound, 0.49);
  EXPECT_EQ(law.stick_samples + law.slip_samples, 4000u);
}

TEST(FrictionRecord, AConstantLawIsNotTakenForAFallingOne) {
  std::vector<double> velocity, force;
  for (std::uint64_t i = 0; i < 500; ++i) {
    velocity.push_back(0.1 + uniform_numbers({4, 0, 0}, i)[0]);
    force.push_back(0.4 + 0.01 * normal_numbers({6, 0, 0}, i)[0]);
  }
  const FrictionLaw law = friction_law({velocity, force, {}}, {0.01, 0.0});
  EXPECT_FALSE(law.falls);
  EXPECT_NEAR(law.kinetic, 0.4, 4.0 * law.kinetic_error);
  EXPECT_FALSE(law.static_bound);
  EXPECT_THROW(friction_law({velocity, force, {}}, {2.0, 0.0}), InputError);
  EXPECT_THROW(friction_law({velocity, force, {}}, {0.0, 0.0}), InputError);
  EXPECT_FALSE(friction_law({std::vector<double>(20, 0.5), std::vector<double>(20, 0.4), {}}, {0.01, 0.0}).remark.empty());
}

TEST(FrictionRecord, SawtoothAndModelForce) {
  const double n = 1.7, k = 0.3, s = 0.5;  // the thesis' slip from μ_S N to (2μ_K − μ_S)N
  const SawtoothFriction found = sawtooth_friction(s * n, (2.0 * k - s) * n, n);
  EXPECT_NEAR(found.kinetic, k, 1e-15);
  EXPECT_NEAR(found.static_bound, s, 1e-15);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_DOUBLE_EQ(contact_force(Eigen::Vector2d(0.0, 1.0), one, 2.0 * one, 3.0 * one, Eigen::Vector2d(1.0, 2.0),
                                 Eigen::Vector2d(1.0, 3.0), Eigen::Vector2d(1.0, 4.0)),
                   16.0);
}

TEST(Phase, OfTwoSensorsIsFoundAndTakenAway) {
  const double f = 12.0, dt = 1e-3, delay = 50.4 / 360.0 / f;
  std::vector<double> reference, late;
  for (int i = 0; i < 700; ++i) {
    const double t = dt * i, w = 2.0 * std::numbers::pi * f;
    const auto signal = [&](double at_time) { return 0.4 + std::cos(w * at_time - 0.7) + 0.2 * std::sin(3.0 * w * at_time); };
    reference.push_back(signal(t));
    late.push_back(signal(t - delay));
  }
  EXPECT_NEAR(sensor_delay(reference, late, dt, f), delay, 2e-6);
  const Harmonics found = fit_harmonics(reference, dt, f, 3);
  EXPECT_NEAR(found.mean, 0.4, 1e-12);
  EXPECT_NEAR(found.amplitude[0], 1.0, 1e-12);
  EXPECT_NEAR(found.phase[0], 0.7, 1e-12);
  EXPECT_NEAR(found.amplitude[2], 0.2, 1e-12);
  EXPECT_LT(found.rest, 1e-12);
  const auto aligned = advanced(late, dt, delay);
  for (std::size_t i = 3; i + 20 < aligned.size(); ++i) EXPECT_NEAR(aligned[i], reference[i], 1e-4);
  EXPECT_TRUE(std::isnan(aligned.back()));
  EXPECT_EQ(advanced(late, dt, 2.0 * dt)[10], late[12]);
  EXPECT_THROW(fit_harmonics(reference, dt, 400.0, 2), InputError);
}

}  // namespace
}  // namespace jointid::oscillation
