#include "modalfit/band/basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "modalfit/model/mac.hpp"

namespace jointid::modalfit {
namespace {

const std::vector<ModelKind> kinds = {
    {Damping::viscous, true}, {Damping::viscous, false}, {Damping::hysteretic, true}, {Damping::hysteretic, false}};
const std::vector<double> lines = {40.0, 49.5, 50.4, 70.0, 81.0};

TEST(Basis, DerivativesAreThoseOfCentralDifferences) {
  for (const ModelKind& kind : kinds) {
    const std::vector<Pole> poles = {{50.0, 0.01}, {80.0, 0.03}};
    const Basis basis = make_basis(kind, poles, lines, 81.0, true);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      for (std::size_t parameter = 0; parameter < 2; ++parameter) {
        constexpr double h = 1e-6;
        const auto moved = [&](double by) {
          std::vector<Pole> at = poles;
          parameter == 0 ? at[mode].frequency_hz *= std::exp(by) : at[mode].damping += by;
          return make_basis(kind, at, lines, 81.0, false);
        };
        const Basis up = moved(h), down = moved(-h);
        for (std::size_t own = 0; own < basis.per_mode; ++own) {
          const std::size_t j = mode * basis.per_mode + own;
          for (std::size_t i = 0; i < lines.size(); ++i) {
            const Complex difference = (up.column(j)[i] - down.column(j)[i]) / (2.0 * h);
            EXPECT_LE(std::abs(basis.derivative(mode, parameter, own)[i] - difference), 2e-6 * std::abs(difference) + 1e-7);
          }
        }
      }
    }
  }
}

/// A mass on spring and damper, from its equation of motion.
TEST(Basis, IsTheReceptanceOfASingleMass) {
  const double mass = 2.0, omega_r = 2.0 * std::numbers::pi * 50.0, zeta = 0.02, eta = 0.04;
  for (const ModelKind& kind : kinds) {
    const bool viscous = kind.damping == Damping::viscous;
    const Basis basis = make_basis(kind, {{50.0, viscous ? zeta : eta}}, lines, 81.0, false);
    // real residue 1/m; as a pole pair R = 1/(2i m ω_r √(1−ζ²))
    const bool pair = viscous && !kind.real_modes;
    const Complex residue = pair ? Complex(0.0, -0.5 / (mass * omega_r * std::sqrt(1.0 - zeta * zeta))) : Complex(1.0 / mass);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double omega = 2.0 * std::numbers::pi * lines[i];
      const Complex stiffness = mass * omega_r * omega_r * (viscous ? Complex(1.0, 2.0 * zeta * omega / omega_r) : Complex(1.0, eta));
      const Complex expected = 1.0 / (stiffness - mass * omega * omega);
      Complex found = residue.real() * basis.column(0)[i];
      if (basis.per_mode == 2) found += residue.imag() * basis.column(1)[i];
      EXPECT_LE(std::abs(found / residue_scale(kind, 81.0) - expected), 1e-12 * std::abs(expected));
    }
  }
}

TEST(Mac, IsOneForShapesThatDifferByAFactorAndZeroForOrthogonalOnes) {
  const std::vector<Complex> shape = {{1.0, 0.5}, {-2.0, 0.0}, {0.0, 1.0}};
  std::vector<Complex> turned = shape;
  for (Complex& value : turned) value *= Complex(0.3, -2.0);
  EXPECT_NEAR(mac(shape, turned), 1.0, 1e-14);
  const std::vector<Complex> a = {1.0, 1.0}, b = {1.0, -1.0}, c = {1.0, 0.0};
  EXPECT_EQ(mac(a, b), 0.0);
  EXPECT_NEAR(mac(a, c), 0.5, 1e-15);
}

}  // namespace
}  // namespace jointid::modalfit
