#include "response/harmonic/harmonic_balance.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "frf/set/frf_system.hpp"
#include "response/structure/frf_receptance.hpp"
#include "response/structure/matrix_receptance.hpp"
#include "tests/friction/random_element.hpp"
#include "tests/require.hpp"
#include "tests/response/golden.hpp"

namespace jointid::response {
namespace {

using golden::json;

Eigen::MatrixXd identity(Eigen::Index n) { return Eigen::MatrixXd::Identity(n, n); }

/// A case with M, C, K, W and forces at all coordinates, responses at all.
HarmonicBalance balance_of(const json& of, std::vector<int> harmonics) {
  const MatrixStructure structure = golden::structure(of);
  const Eigen::MatrixXd all = identity(structure.mass.rows());
  const auto [numbers, amplitudes] = golden::force(of["P"]);
  return {std::make_shared<MatrixReceptance>(structure, golden::matrix(of["W"]), all, all),
          golden::joints(of["joints"]),
          {numbers, amplitudes},
          {.fixed = std::move(harmonics)}};
}

/// Largest residual of (−n²ω²M + inωC + K)X_n + WF_n = P_n over the largest of |K||X_n|.
double full_residual(const MatrixStructure& s, const Eigen::MatrixXd& w, const Excitation& force,
                     const HarmonicSolution& solution) {
  double largest = 0.0, size = 0.0;
  for (std::size_t i = 0; i < solution.harmonics.size(); ++i) {
    const Eigen::Index n = at(i);
    const double omega = solution.harmonics[i] * solution.omega;
    const Eigen::VectorXcd x = solution.response.row(n).transpose(), f = solution.joint_force.row(n).transpose();
    const Eigen::VectorXcd inertia = -omega * omega * (s.mass * x), damping = Complex(0.0, omega) * (s.damping * x),
                           elastic = s.stiffness * x;
    const Eigen::VectorXcd residual = inertia + damping + elastic + w * f - solution.level * force.of(solution.harmonics[i]);
    largest = std::max(largest, residual.cwiseAbs().maxCoeff());
    size = std::max(size, (s.stiffness.cwiseAbs() * x.cwiseAbs()).maxCoeff());
  }
  return largest / size;
}

/// ∮p·ẋ − ∮ẋᵀCẋ − ΣD over ∮p·ẋ, forces at all coordinates.
double energy_defect(const MatrixStructure& s, const Excitation& force, const HarmonicSolution& solution) {
  double work = 0.0, damped = 0.0;
  for (std::size_t i = 0; i < solution.harmonics.size(); ++i) {
    const int n = solution.harmonics[i];
    const Eigen::VectorXcd x = solution.response.row(at(i)).transpose(), p = force.of(n);
    work += std::numbers::pi * n * (p.array() * x.array().conjugate()).imag().sum();
    damped += std::numbers::pi * n * n * solution.omega * x.dot(s.damping * x).real();
  }
  return (work - damped - solution.loss.sum()) / work;
}

TEST(HarmonicBalance, MeetsTheGoldenSteadyStates) {
  const auto cases = golden::cases("masing_steady");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    for (const auto& [largest, expected] : each["hb"].items()) {
      const HarmonicBalance balance = balance_of(each, golden::integers(expected["harmonics"]));
      const HarmonicSolution found = balance.solve(each["omega"]);
      const std::string id = each["id"].get<std::string>() + " to " + largest;
      ASSERT_TRUE(found.converged) << id;
      const double tolerance = golden::tolerance(each["hb_trusted_digits"]);
      for (std::size_t n = 0; n < found.harmonics.size(); ++n) {
        const auto row = [&](const Eigen::MatrixXcd& m) { return Eigen::VectorXcd(m.row(at(n)).transpose()); };
        const double q = found.joint_motion.cwiseAbs().maxCoeff(), f = found.joint_force.cwiseAbs().maxCoeff(),
                     x = found.response.cwiseAbs().maxCoeff();
        EXPECT_LE((row(found.joint_motion) - golden::complex_vector(expected["Q"][n])).cwiseAbs().maxCoeff(), tolerance * q)
            << id;
        EXPECT_LE((row(found.joint_force) - golden::complex_vector(expected["F"][n])).cwiseAbs().maxCoeff(), tolerance * f) << id;
        EXPECT_LE((row(found.response) - golden::complex_vector(expected["X"][n])).cwiseAbs().maxCoeff(), tolerance * x) << id;
      }
      const auto [numbers, amplitudes] = golden::force(each["P"]);
      EXPECT_LE(full_residual(golden::structure(each), golden::matrix(each["W"]), {numbers, amplitudes}, found), 1e-14) << id;
      EXPECT_LE(std::abs(energy_defect(golden::structure(each), {numbers, amplitudes}, found)), 1e-12) << id;
    }
  }
}

/// Towards the exact orbit: the error of X₁ falls with the harmonics.
TEST(HarmonicBalance, ManyHarmonicsMeetTheExactOrbits) {
  const auto cases = golden::cases("masing_steady");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const auto [numbers, amplitudes] = golden::force(each["P"]);
    const HarmonicBalance balance = balance_of(each, needed_harmonics({numbers, amplitudes}, 31).numbers());
    const HarmonicSolution found = balance.solve(each["omega"]);
    ASSERT_TRUE(found.converged);
    const json& exact = each["exact"];
    const auto order = golden::integers(exact["harmonics"]);
    const Eigen::Index first = Harmonics(order).find(1), own = Harmonics(found.harmonics).find(1);
    const Eigen::VectorXcd expected = golden::complex_vector(exact["X"][static_cast<std::size_t>(first)]);
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.response.row(own).transpose()), expected), 1e-5) << each["id"];
    for (std::size_t j = 0; j < exact["dissipated"].size(); ++j) {
      EXPECT_NEAR(found.loss(at(j)), exact["dissipated"][j].get<double>(), 1e-4 * found.loss.maxCoeff()) << each["id"];
    }
  }
}

/// H_a and H_b as files of one structure each, with lines at the harmonics.
frf::FrfSet part(const json& receptances, double omega, const std::vector<int>& harmonics, int first_node) {
  frf::FrfSet set;
  const std::size_t n = receptances[0].size();
  for (const int harmonic : harmonics) set.header.frequency_hz.push_back(harmonic * omega / (2.0 * std::numbers::pi));
  for (std::size_t i = 0; i < n; ++i) set.header.response.push_back({first_node + static_cast<int>(i), frf::Direction::x, 1});
  set.header.reference = set.header.response;
  for (const auto& line : receptances) {
    for (const auto& row : line) {
      for (const auto& value : row) set.values.push_back(golden::complex(value));
    }
  }
  return set;
}

TEST(HarmonicBalance, CouplesMeasuredParts) {
  const auto cases = golden::cases("receptance_coupling");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  for (const auto& each : cases) {
    const auto harmonics = golden::integers(each["harmonics"]);
    const double omega = each["omega"];
    const int size_a = static_cast<int>(each["H_a"][0].size()), size_b = static_cast<int>(each["H_b"][0].size());
    std::vector<frf::FrfSet> sets = {part(each["H_a"], omega, harmonics, 1), part(each["H_b"], omega, harmonics, 1 + size_a)};
    const auto system = frf::memory_system("substructures", std::move(sets), frf::Composition::uncoupled);
    const auto dof = [](int node) { return frf::Dof{node, frf::Direction::x, 1}; };
    std::vector<frf::Dof> all;
    for (int i = 1; i <= size_a + size_b; ++i) all.push_back(dof(i));
    const auto structure = std::make_shared<FrfReceptance>(*system, std::vector<JointEnds>{{dof(size_a), dof(size_a + 1)}}, all,
                                                           std::vector<frf::Dof>{dof(1)});
    const std::vector<Joint> joints = {{.name = "joint", .friction = golden::element(each)}};
    const HarmonicSolution found = HarmonicBalance(structure, joints, Excitation::single(6.0), {.fixed = harmonics}).solve(omega);
    ASSERT_TRUE(found.converged) << each["id"];
    const double tolerance = golden::tolerance(each["trusted_digits"]);
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.joint_motion.col(0)), golden::complex_vector(each["Q"])), tolerance)
        << each["id"];
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.joint_force.col(0)), golden::complex_vector(each["F"])), tolerance)
        << each["id"];
    EXPECT_LE(golden::difference(found.response, golden::complex_matrix(each["X"])), tolerance) << each["id"];
    EXPECT_NEAR(found.loss(0), each["dissipated"].get<double>(), tolerance * found.loss(0)) << each["id"];

    // A harmonic beyond the lines is told with what it would move.
    std::vector<int> more = harmonics;
    more.push_back(harmonics.back() + 2);
    const HarmonicSolution beyond = HarmonicBalance(structure, joints, Excitation::single(6.0), {.fixed = more}).solve(omega);
    ASSERT_EQ(beyond.dropped.size(), 1u);
    EXPECT_EQ(beyond.dropped[0].harmonic, more.back());
    EXPECT_GT(beyond.dropped[0].motion, 0.0);
    EXPECT_EQ(beyond.harmonics, harmonics);
    EXPECT_THROW(HarmonicBalance(structure, joints, Excitation::single(6.0), {.fixed = harmonics}).solve(1.1 * omega),
                 InputError);
  }
}

/// The thesis's two beams with both joints of a type, forces at coordinate 5 and responses at all.
HarmonicBalance beams(const json& each, const std::string& type, const std::vector<int>& harmonics, Complex amplitude) {
  const MatrixStructure structure = golden::structure(each);
  const json& law = each["joint_types"][type];
  const Joint joint = {.name = type, .friction = golden::element(law)};
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(structure.mass.rows(), 1);
  force(4, 0) = 1.0;
  return {std::make_shared<MatrixReceptance>(structure, golden::matrix(each["W"]), identity(structure.mass.rows()), force),
          {joint, joint},
          Excitation::single(amplitude),
          {.fixed = harmonics}};
}

void expect_beams(const HarmonicSolution& found, const json& expected, double tolerance, const std::string& id) {
  ASSERT_TRUE(found.converged) << id;
  if (expected.contains("X5")) {
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.response.col(4)), golden::complex_vector(expected["X5"])), tolerance)
        << id;
  }
  if (expected.contains("Q2")) {
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.joint_motion.col(1)), golden::complex_vector(expected["Q2"])), tolerance)
        << id;
  }
  if (expected.contains("F2")) {
    EXPECT_LE(golden::difference(Eigen::VectorXcd(found.joint_force.col(1)), golden::complex_vector(expected["F2"])), tolerance)
        << id;
  }
}

/// Largest |x₅| of a period, near the largest of 2,000 samples by the parabola through three.
double largest_of_coordinate_5(const HarmonicSolution& found) {
  constexpr int samples = 2000;
  const Motion motion(Harmonics(found.harmonics), found.response.col(4));
  const auto size = [&](int i) { return std::abs(motion.value(2.0 * std::numbers::pi * i / samples)); };
  int best = 0;
  for (int i = 1; i < samples; ++i) best = size(i) > size(best) ? i : best;
  const double before = size(best - 1), at = size(best), after = size(best + 1);
  return at - 0.125 * (after - before) * (after - before) / (before - 2.0 * at + after);
}

/// What is told beside a solution: decibels of X over p and F over p, the errors against the exact orbit (three digits).
void expect_figures(const HarmonicSolution& found, const json& expected, const json& steady, double p, const std::string& id) {
  const auto decibels = [&](const Eigen::VectorXcd& values, const char* key) {
    if (!expected.contains(key)) return;
    for (std::size_t n = 0; n < expected[key].size(); ++n) {
      const double level = std::abs(values(at(n))) / p;
      if (std::abs(values(at(n))) > 1e-12 * std::abs(values(0))) {
        EXPECT_NEAR(20.0 * std::log10(level), expected[key][n].get<double>(), 2e-5) << id << key;
      } else {
        EXPECT_LT(expected[key][n], -250.0) << id << key;
      }
    }
  };
  decibels(found.response.col(4), "X5_dB");
  decibels(found.joint_force.col(1), "F2_dB");
  EXPECT_EQ(expected.value("converged", true), found.converged) << id;
  if (!expected.contains("x5_max")) return;
  const double largest = largest_of_coordinate_5(found), exact = steady["x5_max"];
  EXPECT_NEAR(largest / expected["x5_max"].get<double>(), 1.0, 1e-7) << id;
  EXPECT_NEAR(std::abs(largest / exact - 1.0) / expected["error_x5_max"].get<double>(), 1.0, 6e-3) << id;
  const Complex first = golden::complex(steady["X5"][0]);
  EXPECT_NEAR(std::abs(found.response(0, 4) - first) / std::abs(first) / expected["error_X5_first"].get<double>(), 1.0, 6e-3) << id;
}

TEST(HarmonicBalance, MeetsTheBeamsOfTheThesis) {
  const auto cases = golden::cases("thesis_18dof");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  const json& each = cases.front();
  const double omega = each["omega"];
  const Complex sine = {0.0, -1.0};
  expect_beams(beams(each, "A", {1}, sine).solve(omega), each["type_A"]["steady"], golden::tolerance(9), "A");
  for (const std::string type : {"B", "C", "E"}) {
    const std::string key = "type_" + type;
    if (!each.contains(key) || !each[key].contains("hb")) continue;
    for (const auto& [largest, expected] : each[key]["hb"].items()) {
      const HarmonicBalance balance = beams(each, type, golden::integers(expected["harmonics"]), sine);
      const HarmonicSolution found = balance.solve(omega);
      expect_beams(found, expected, golden::tolerance(each[key]["trusted_digits"]["hb"]), type + " to " + largest);
      expect_figures(found, expected, each[key]["steady"], 1.0, type + " to " + largest);
    }
  }
  const json& levels = each["levels_50Hz_B"];
  const HarmonicBalance balance = beams(each, "B", golden::integers(levels["harmonics"]), sine);
  for (const auto& level : levels["values"]) {
    const HarmonicSolution found = balance.solve(omega, level["p"]);
    expect_beams(found, level, golden::tolerance(levels["trusted_digits"]), "level");
    expect_figures(found, level, {}, level["p"], "level");
  }
}

TEST(HarmonicBalance, FullEquationsHoldForTheBeams) {
  const auto cases = golden::cases("thesis_18dof");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  const json& each = cases.front();
  const HarmonicSolution found = beams(each, "B", {1, 3, 5, 7, 9}, {0.0, -1.0}).solve(each["omega"]);
  Excitation everywhere = {{1}, Eigen::MatrixXcd::Zero(1, 18)};
  everywhere.amplitudes(0, 4) = {0.0, -1.0};
  EXPECT_LE(full_residual(golden::structure(each), golden::matrix(each["W"]), everywhere, found), 1e-14);
  EXPECT_LE(std::abs(energy_defect(golden::structure(each), everywhere, found)), 1e-10);
}

TEST(HarmonicBalance, AddsHarmonicsUntilTheNextDoNotMatter) {
  const auto cases = golden::cases("thesis_18dof");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  const json& each = cases.front();
  const HarmonicBalance fixed = beams(each, "B", {1}, {0.0, -1.0});
  const double omega = each["omega"];
  const auto solve = [&](double tolerance) {
    return HarmonicBalance(std::make_shared<MatrixReceptance>(dynamic_cast<const MatrixReceptance&>(fixed.structure())),
                           fixed.joints(), fixed.force(), {.tolerance = tolerance, .largest = 101})
        .solve(omega);
  };
  const HarmonicSolution coarse = solve(1e-3), fine = solve(1e-5);
  ASSERT_TRUE(coarse.converged && fine.converged);
  EXPECT_LT(coarse.harmonics.back(), fine.harmonics.back());
  EXPECT_LE(fine.next, 1e-5);
  const HarmonicSolution best = beams(each, "B", Harmonics::odd(101).numbers(), {0.0, -1.0}).solve(omega);
  const double size = best.response.cwiseAbs().maxCoeff();
  EXPECT_LE((fine.response.row(0) - best.response.row(0)).cwiseAbs().maxCoeff(), 1e-4 * size);
}

/// Type D sticks and slips with 1e10 N/m: no plain start converges at 1 N, springs in series lead there.
TEST(HarmonicBalance, SpringsInSeriesLeadToVeryStiffJoints) {
  const auto cases = golden::cases("thesis_18dof");
  if (cases.empty()) JOINTID_SKIP("no reference file " << golden::file());
  const json& each = cases.front();
  EXPECT_TRUE(beams(each, "D", {1, 3, 5, 7, 9}, {0.0, -100.0}).solve(each["omega"]).converged);
  const HarmonicSolution found = beams(each, "D", Harmonics::odd(29).numbers(), {0.0, -1.0}).solve(each["omega"]);
  ASSERT_TRUE(found.converged);
  EXPECT_EQ(found.start, Start::stiffness);
  Excitation everywhere = {{1}, Eigen::MatrixXcd::Zero(1, 18)};
  everywhere.amplitudes(0, 4) = {0.0, -1.0};
  EXPECT_LE(full_residual(golden::structure(each), golden::matrix(each["W"]), everywhere, found), 1e-12);
  const Motion fifth(Harmonics(found.harmonics), found.response.col(4));
  double largest = 0.0;
  for (int i = 0; i < 2000; ++i) largest = std::max(largest, std::abs(fifth.value(2.0 * std::numbers::pi * i / 2000.0)));
  EXPECT_NEAR(largest, 1.159558e-6, 0.01 * 1.159558e-6);  // exact marching, theory sheet §11
}

/// Masses between springs, the first to ground, with one to three joints of any law between any two of them or to ground.
RC_GTEST_PROP(HarmonicBalance, FindsAResponseOfAnyStructure, ()) {
  using friction::any_decade, friction::any_in, friction::any_of;
  const Eigen::Index n = 1 + at(any_of(6));
  MatrixStructure s = {identity(n), {}, Eigen::MatrixXd::Zero(n, n)};
  for (Eigen::Index i = 0; i < n; ++i) {
    const double spring = any_in(5e6, 2e7);
    s.mass(i, i) = any_in(0.5, 2.0);
    s.stiffness(i, i) += spring;
    if (i == 0) continue;
    s.stiffness(i - 1, i - 1) += spring;
    s.stiffness(i, i - 1) = s.stiffness(i - 1, i) = -spring;
  }
  s.damping = any_decade(1e-6, 2e-5) * s.stiffness;
  Eigen::MatrixXd w = Eigen::MatrixXd::Zero(n, 1 + at(any_of(3)));
  std::vector<Joint> joints;
  for (Eigen::Index j = 0; j < w.cols(); ++j) {
    const Eigen::Index from = at(any_of(static_cast<std::size_t>(n))), to = at(any_of(static_cast<std::size_t>(n)));
    w(from, j) += 1.0;
    if (to != from) w(to, j) -= 1.0;
    joints.push_back({.name = "joint", .friction = std::shared_ptr<const friction::Element>(friction::any_single())});
    RC_LOG() << friction::describe(*joints.back().friction);
  }
  const bool odd = any_of(3) > 0;
  Excitation force = {odd ? std::vector<int>{1, 3} : std::vector<int>{0, 1, 2}, Eigen::MatrixXcd(odd ? 2 : 3, n)};
  for (Complex& p : force.amplitudes.reshaped()) p = any_decade(0.1, 30.0) * Complex(any_in(-1.0, 1.0), any_in(-1.0, 1.0));
  if (!odd) force.amplitudes.row(0) = force.amplitudes.row(0).real().cast<Complex>();
  const Harmonics harmonics =
      odd ? Harmonics::odd(3 + 2 * static_cast<int>(any_of(5))) : Harmonics::all(2 + static_cast<int>(any_of(5)));
  const HarmonicBalance balance(std::make_shared<MatrixReceptance>(s, w, identity(n), identity(n)), joints, force,
                                {.fixed = harmonics.numbers()});
  const HarmonicSolution found = balance.solve(any_in(300.0, 9000.0));
  RC_LOG() << "omega " << found.omega << ", residual " << found.residual << ", steps " << found.steps << "\n";
  RC_ASSERT(found.converged);
  // The forces of stiff joints carry the rounding of the motion times their stiffness.
  double stiffest = 0.0;
  for (const Joint& joint : joints) stiffest = std::max(stiffest, joint.stuck_stiffness());
  RC_ASSERT(full_residual(s, w, force, found) <= 1e-12 * std::max(1.0, stiffest / 1e7));
}

/// A joint that cancels the stiffness of the structure: there is no response, and the result says so.
TEST(HarmonicBalance, SaysWhenItDoesNotConverge) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  const auto structure = std::make_shared<MatrixReceptance>(MatrixStructure{one, 0.0 * one, 2.0 * one}, one, one, one);
  const Joint joint = {.name = "joint", .friction = {}, .stiffness = -1.0};
  EXPECT_FALSE(HarmonicBalance(structure, {joint}, Excitation::single(1.0), {.fixed = {1}}).solve(1.0).converged);
  EXPECT_TRUE(HarmonicBalance(structure, {joint}, Excitation::single(1.0), {.fixed = {1}}).solve(1.1).converged);
  EXPECT_THROW(HarmonicBalance(structure, {joint}, Excitation::single(1.0), {.fixed = {1}}).solve(0.0), InputError);
  EXPECT_THROW(HarmonicBalance(structure, {}, Excitation::single(1.0), {.fixed = {1}}), InputError);
}

}  // namespace
}  // namespace jointid::response
