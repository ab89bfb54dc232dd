#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/error.hpp"
#include "oscillation/measurement/reversal.hpp"
#include "oscillation/system/contact_system.hpp"
#include "oscillation/system/normal_vibration.hpp"
#include "oscillation/system/thesis_systems.hpp"
#include "oscillation/system/timoshenko.hpp"
#include "tests/golden_json.hpp"
#include "tests/require.hpp"

/// What chapters 4 to 7 of Kappagantu's thesis add to the contact, against golden/seeds.json (seeds.md 13).
namespace jointid::oscillation {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

nlohmann::json small_golden() {
  const nlohmann::json found = golden_case("seeds.json", "name", "kappagantu_small");
  return found.is_null() ? found : found["expected"];
}

double part_difference(const nlohmann::json& expected, std::complex<double> found) {
  return std::abs(std::complex<double>(expected[0].get<double>(), expected[1].get<double>()) - found);
}

TEST(Tilt, GivesTheGoldenCoefficients) {
  const nlohmann::json golden = small_golden();
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  for (const nlohmann::json& each : golden["tilt"]) {
    const double mu = each["mu"], tilt = each["theta_deg"].get<double>() * degree;
    EXPECT_NEAR(tilted(mu, tilt, Mode::forward), each["forward"].get<double>(), 1e-11);
    EXPECT_NEAR(-tilted(mu, tilt, Mode::backward), each["backward"].get<double>(), 1e-11);
  }
}

/// The same from the two balances of a block on an incline: along the motion and across it.
TEST(Tilt, IsTheBalanceOfABlock) {
  for (const double tilt : {-0.1, 0.02, 0.2}) {
    for (const double mu : {0.3, 0.55}) {
      const double load = 1.0 / (std::cos(tilt) - mu * std::sin(tilt));  // N_x for N_Z = 1
      EXPECT_NEAR(tilted(mu, tilt, Mode::forward), load * (std::sin(tilt) + mu * std::cos(tilt)), 1e-14);
    }
  }
}

TEST(Tilt, ThatLocksOrSlidesByItselfIsAnError) {
  BeltChain chain;
  for (const double tilt : {0.29, 1.3, -1.3}) {
    chain.friction.tilt = tilt;
    if (tilt == 0.29) {
      EXPECT_NO_THROW(contact_system(chain));
    } else {
      EXPECT_THROW(contact_system(chain), InputError);
    }
  }
}

TEST(NormalVibration, MeetsTheGoldenPhasors) {
  const nlohmann::json golden = small_golden();
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  const nlohmann::json &all = golden["normal_vibrations"], &p = all["parameters"];
  const NormalVibration system{p["mb"], p["kb"], p["ke"], p["cb"], p["ce"], p["Zm"], p["Zc"]};
  EXPECT_NEAR(system.natural_hz(), all["natural_hz"].get<double>(), 1e-9);
  EXPECT_NEAR(system.static_slope(), golden["quasi_static_slope"].get<double>(), 1e-10);
  for (const nlohmann::json& point : all["points"]) {
    const NormalMotion found = normal_motion(system, p["A"], 2.0 * std::numbers::pi * point["hz"].get<double>());
    EXPECT_NEAR(found.rest, point["Zb0"].get<double>(), 1e-14);
    EXPECT_NEAR(found.force, point["N0"].get<double>(), 1e-11);
    EXPECT_LT(part_difference(point["Zb1"], found.first), 1e-10 * std::abs(found.first));
    EXPECT_LT(part_difference(point["N1"], found.force_first), 1e-10 * std::abs(found.force_first));
  }
}

/// Slow sliders: N = N₀ + N_m d.
TEST(NormalVibration, OfASlowSliderIsTheStaticSlope) {
  const NormalVibration system{0.02, 800.0, 300.0, 0.1, 0.05, -0.004, 0.001};
  const NormalMotion found = normal_motion(system, 0.002, 1e-4);
  EXPECT_NEAR(found.force_first.real(), 0.002 * system.static_slope(), 1e-12);
  EXPECT_NEAR(found.force_first.imag(), 0.0, 1e-8);
}

TEST(Timoshenko, MeetsTheGoldenBeams) {
  const nlohmann::json golden = golden_case("seeds.json", "name", "timoshenko");
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  const nlohmann::json &in = golden["input"], &expected = golden["expected"];
  for (const char* which : {"thin", "thick"}) {
    const ThickBeam beam{in["L"], in["b"], in[which], in["E"], in["rho"], in["nu"]};
    EXPECT_NEAR(beam.shear_coefficient(), in["kappa"].get<double>(), 1e-11);
    const std::vector<ThickMode> modes = thick_modes(beam, 6);
    const nlohmann::json& euler = expected[std::string(which) == "thin" ? "euler_thin_hz" : "thick_euler_hz"];
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(modes[k].euler_hz / euler[k].get<double>(), 1.0, 1e-8);
      const nlohmann::json& first = expected["first_order"][which][k];
      EXPECT_NEAR(modes[k].rotary / first[0].get<double>(), 1.0, 1e-7);
      EXPECT_NEAR(modes[k].shear / first[1].get<double>(), 1.0, 1e-7);
      if (std::string(which) == "thick") {
        EXPECT_NEAR(modes[k].timoshenko_hz / expected["thick_timoshenko_hz"][k].get<double>(), 1.0, 2e-5);
      }
    }
  }
}

/// First order and exact frequencies part with the square of the thickness, with a tip mass, too.
TEST(Timoshenko, ChangesByTheFirstOrderOfAThinBeam) {
  const ThickBeam beam{0.3, 0.02, 0.004, 7e10, 2700.0, 0.33, 0.05};
  for (const ThickMode& mode : thick_modes(beam, 4)) {
    const double change = mode.timoshenko_hz / mode.euler_hz - 1.0, first = mode.rotary + mode.shear;
    EXPECT_NEAR(change, first, 3.0 * first * first + 1e-8) << mode.euler_hz;
  }
}

TEST(Timoshenko, EulersFrequenciesAreThoseOfTheCantilever) {
  const Cantilever beam;
  const Eigen::VectorXd expected = tip_mass_frequencies(beam);
  const ThickBeam thick{beam.length, beam.width, beam.thickness, beam.youngs_modulus, beam.density, 0.34, beam.tip_mass()};
  const std::vector<ThickMode> modes = thick_modes(thick, 6);
  for (Eigen::Index k = 0; k < 6; ++k) EXPECT_NEAR(modes[static_cast<std::size_t>(k)].euler_hz / expected(k), 1.0, 1e-9);
}

TEST(Timoshenko, OfNoBeamIsAnError) {
  EXPECT_THROW(thick_modes({0.4, 0.01, 0.001, 1e11, 7000.0, 0.7}, 2), InputError);
  EXPECT_THROW(thick_modes({0.0, 0.01, 0.001, 1e11, 7000.0, 0.3}, 2), InputError);
}

/// A slider that moves to and fro; Coulomb friction behind a spring K_C, the body a spring k. `late`: samples by which the force is late.
struct Rubbing {
  std::vector<double> slider, relative, force;
};

Rubbing rubbed(double contact, double body, double limit, std::size_t late = 0) {
  constexpr int samples = 4000, cycles = 5;
  const double series = contact * body / (contact + body);
  Rubbing out;
  double force = 0.0, before = 0.0;
  for (int i = 0; i <= samples * cycles; ++i) {
    const double d = 8.0 * limit / series * std::sin(2.0 * std::numbers::pi * i / samples);
    force = std::clamp(force + series * (d - before), -limit, limit);
    before = d;
    out.slider.push_back(d);
    out.relative.push_back(d - force / body);
    out.force.push_back(force);
  }
  out.force.insert(out.force.begin(), late, 0.0);
  out.force.resize(out.slider.size());
  return out;
}

TEST(Reversal, HasTheGoldenSlopes) {
  const nlohmann::json golden = small_golden();
  if (golden.is_null()) JOINTID_SKIP("no golden seeds");
  const nlohmann::json& one = golden["reversal"];
  const double contact = one["K_C"], body = one["k_body"], limit = one["slip_force"];
  const Rubbing record = rubbed(contact, body, limit);
  const ReversalStiffness relative = reversal_stiffness({record.relative, record.force});
  EXPECT_NEAR(relative.slope / one["slope_relative"].get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(relative.stuck_travel, one["deflection_per_reversal"].get<double>(), 1e-14);
  EXPECT_NEAR(relative.slip_force, limit, 1e-15);
  EXPECT_GE(relative.forward.parts, 4u);
  EXPECT_GE(relative.backward.parts, 4u);
  const ReversalStiffness slider = reversal_stiffness({record.slider, record.force}, {.body_stiffness = body});
  EXPECT_NEAR(slider.slope / one["slope_slider"].get<double>(), 1.0, 1e-9);
  EXPECT_NEAR(slider.stiffness / contact, 1.0, 1e-7);
}

/// A sine speeds up after its reversals: a late force makes both directions too flat, as much.
TEST(Reversal, OfALateForceIsTooFlatBothWays) {
  const Rubbing record = rubbed(20000.0, 900.0, 0.19, 3);
  const ReversalStiffness found = reversal_stiffness({record.slider, record.force}, {.body_stiffness = 900.0});
  EXPECT_NEAR(found.forward.slope / found.backward.slope, 1.0, 1e-3);
  EXPECT_LT(found.slope, 0.995 * 861.244);
  EXPECT_GT(found.slope, 0.98 * 861.244);
}

TEST(Reversal, SaysWhatTheRecordLacks) {
  const Rubbing record = rubbed(20000.0, 900.0, 0.19);
  std::vector<double> turned = record.force;
  for (double& each : turned) each = -each;
  EXPECT_THROW(reversal_stiffness({record.slider, turned}), InputError);
  EXPECT_THROW(reversal_stiffness({record.slider, std::vector<double>(record.slider.size(), 0.0)}), InputError);
  EXPECT_THROW(reversal_stiffness({record.slider, record.force}, {.body_stiffness = 800.0}), InputError);
  EXPECT_THROW(reversal_stiffness({std::span(record.slider).first(50), record.force}), InputError);
  const Rubbing once = rubbed(20000.0, 900.0, 0.19);
  const ReversalStiffness half = reversal_stiffness({std::span(once.slider).first(2500), std::span(once.force).first(2500)});
  EXPECT_FALSE(half.remark.empty());
}

}  // namespace
}  // namespace jointid::oscillation
