#include <gmock/gmock.h>

#include <Eigen/Core>
#include <cmath>
#include <set>

#include "base/control.hpp"
#include "base/error.hpp"
#include "beam_chain.hpp"
#include "dense/eigen.hpp"
#include "ident/admissible/constraint_phrases.hpp"
#include "ident/admissible/tie.hpp"
#include "ident/judgement/loose_joints.hpp"
#include "ident/scene/read_scene.hpp"
#include "tests/ident/likelihood_case.hpp"
#include "tests/ident/memory_systems.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

struct MethodOneCase : LikelihoodCase {
  explicit MethodOneCase(const std::string& name) : LikelihoodCase(name) { scene.identify.method = Method::one; }
};

double value_of(const Solution& solution, const std::string& name) {
  for (const Estimate& each : solution.unknowns) {
    if (each.name == name) return each.value;
  }
  return std::nan("");
}

TEST(Inequalities, AreReadAsOneOrTwoRows) {
  const std::vector<std::string> names = {"K(1,1)", "K(2,2)", "D(1,1)"};
  const auto two = parse_inequality("0.01*K(1,1) <= D(1,1) <= 0.1*K(1,1) + 5", names);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0].coefficients, Eigen::Vector3d(-0.01, 0.0, 1.0));
  EXPECT_EQ(two[1].coefficients, Eigen::Vector3d(0.1, 0.0, -1.0));
  EXPECT_EQ(two[1].constant, 5.0);
  EXPECT_EQ(two[0].text, "0.01*K(1,1) <= D(1,1)");
  EXPECT_EQ(parse_inequality("K(1,1) >= 2*K(2,2)", names)[0].coefficients, Eigen::Vector3d(1.0, -2.0, 0.0));
  const auto error_of = [&](const char* text) -> std::string {
    try {
      parse_inequality(text, names);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("K(1,1) < K(2,2)"), HasSubstr("needs <= or >="));
  EXPECT_THAT(error_of("K(1,1)"), HasSubstr("write \"K(1,1) >= 2*K(2,2)\""));
  EXPECT_THAT(error_of("1 <= K(1,1) >= 2"), HasSubstr("none of one or two equal relations"));
  EXPECT_THAT(error_of("D(1,1)/K(1,1) <= 0.1"), HasSubstr("is not linear in unknowns"));
  EXPECT_THAT(error_of("D(9,1) <= 0.1"), HasSubstr("the joint has no unknown D(9,1)"));
}

/// An inequality that holds at its limit is a tie, and with one unknown a bound.
TEST(Inequalities, AgreeWithTiesAndBoundsThatHold) {
  MethodOneCase a1("A1");
  const double free = value_of(solve(*a1.polluted()), "K(1,1)");
  MethodOneCase tied = a1, held = a1, bounded = a1, limited = a1;
  tied.scene.identify.ties = {"D(1,1) = 0.2*K(1,1)"};
  held.scene.identify.inequalities = {"D(1,1) >= 0.2*K(1,1)"};
  bounded.scene.identify.bounds = {{"K(1,1)", -1e9, 0.9 * free}};
  limited.scene.identify.inequalities = {"2*K(1,1) <= " + std::to_string(1.8 * free)};
  const Solution by_tie = solve(*tied.polluted()), by_row = solve(*held.polluted());
  const Solution by_bound = solve(*bounded.polluted()), by_limit = solve(*limited.polluted());
  for (std::size_t u = 0; u < by_tie.unknowns.size(); ++u) {
    EXPECT_NEAR(by_row.unknowns[u].value, by_tie.unknowns[u].value, 1e-4 * std::abs(by_tie.unknowns[u].value)) << u;
    EXPECT_NEAR(by_limit.unknowns[u].value, by_bound.unknowns[u].value, 1e-4 * std::abs(by_bound.unknowns[u].value)) << u;
  }
  EXPECT_EQ(by_row.unknowns[0].limit, "at the limit of D(1,1) >= 0.2*K(1,1)");
  EXPECT_THAT(constraint_phrases(*held.clean()), ElementsAre("D(1,1) >= 0.2*K(1,1)"));
}

TEST(Passive, DampingIsSemidefiniteOverTheBand) {
  MethodOneCase a1("A1");
  a1.scene.joints[0].matrices[Kind::viscous_damping] = restrictions::Pattern::symmetric;
  const auto least = [](const Solution& found, double hz) {
    Eigen::Matrix4d z;
    for (Eigen::Index i = 0; i < 4; ++i) {
      for (Eigen::Index j = 0; j < 4; ++j) {
        const auto r = static_cast<std::size_t>(i), c = static_cast<std::size_t>(j);
        z(i, j) = found.bands[0].matrices.at(Kind::hysteretic_damping)[r][c] +
                  2.0 * 3.141592653589793 * hz * found.bands[0].matrices.at(Kind::viscous_damping)[r][c];
      }
    }
    const Eigen::VectorXd values = dense::symmetric_eigenvalues(z);
    return values[0] / values[3];
  };
  const Solution free = solve(*a1.polluted());
  ASSERT_LT(std::min(least(free, 100.0), least(free, 1500.0)), -1e-3);
  a1.scene.identify.passive_hz = Range{100.0, 1500.0};
  const Solution found = solve(*a1.polluted());
  for (const double hz : {100.0, 400.0, 1000.0, 1500.0}) EXPECT_GT(least(found, hz), -1e-9) << hz;
  EXPECT_GT(found.admissibility->equations, 0u);
  EXPECT_THAT(constraint_phrases(*a1.clean()),
              ElementsAre("Im Z at 100 Hz positive semidefinite", "Im Z at 1500 Hz positive semidefinite"));
  a1.scene.joints[0].matrices = {{Kind::stiffness, restrictions::Pattern::symmetric}};
  try {
    a1.clean();
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no joint has viscous or hysteretic damping"));
  }
}

/// H_nn alone: a bound that holds is a tie, by every way of the method.
TEST(NewtonConstraints, ABoundThatHoldsIsATie) {
  const auto problem = problems::make("H4");
  Scene scene = problems::scene(problem);
  scene.identify.start = scene.truth;
  const auto solved = [&](const Scene& each) {
    Control control;
    control.threads = 1;
    return solve(*problems::plan(each, {problem.substructures, problem.assembly}), control);
  };
  Scene inactive = scene, bounded = scene, tied = scene, definite = scene;
  const double truth = problem.unknowns[0].value;
  const std::string name = problem.unknowns[0].name;
  inactive.identify.bounds = {{name, 0.5 * truth, 2.0 * truth}};
  const Solution free = solved(inactive);
  EXPECT_EQ(free.status, Status::ok);
  for (std::size_t u = 0; u < free.unknowns.size(); ++u)
    EXPECT_NEAR(free.unknowns[u].value, problem.unknowns[u].value, 1e-7 * std::abs(problem.unknowns[u].value));
  EXPECT_EQ(free.admissibility->equations, 0u);
  bounded.identify.bounds = {{name, 0.0, 0.9 * truth}};
  tied.identify.ties = {name + " = " + std::to_string(0.9 * truth)};
  const Solution by_tie = solved(tied), by_bound = solved(bounded);
  EXPECT_EQ(by_bound.status, by_tie.status);
  EXPECT_EQ(by_bound.unknowns[0].limit, "at its upper bound");
  EXPECT_GT(by_bound.admissibility->chi_square, 1.0);
  for (std::size_t u = 0; u < by_tie.unknowns.size(); ++u) {
    EXPECT_NEAR(by_bound.unknowns[u].value, by_tie.unknowns[u].value, 2e-3 * std::abs(by_tie.unknowns[u].value)) << u;
  }
  definite.joints[0].definite = {Kind::stiffness};
  definite.identify.solver = Solver::newton;
  EXPECT_EQ(solved(definite).status, Status::ok);
}

TEST(Loose, TheProbabilityIsOfTheOutliers) {
  std::vector<NominalShare> shares;
  for (int e = 0; e < 20; ++e) shares.push_back({1.0 + 0.02 * std::sin(3.7 * e), 0.02});
  shares[4].share = 0.3;
  shares[11].share = 0.6;
  shares[17].share = 1.5;  // stiffer is not loose
  const std::vector<double> found = looseness(shares);
  for (std::size_t e = 0; e < found.size(); ++e) {
    const bool is_loose = e == 4 || e == 11;
    EXPECT_TRUE(is_loose ? found[e] > 0.999 : found[e] < 0.05) << e << ' ' << found[e];
  }
}

/// A chain of ten joints, 5 and 9 of it loose, all coordinates measured, 1 % noise.
MemoryScene loose_chain(double level, unsigned seed, double parts_level) {
  BeamChain chain;
  chain.joints = 10;
  chain.lost.assign(10, 0.0);
  chain.lost[5] = 0.6;
  chain.lost[8] = 0.8;
  const BeamChain nominal{.joints = 10};
  MemoryScene out;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto noisy = [&](Complex value, double own_level) {
    const double a = normal(random), b = normal(random);
    return value + own_level * std::abs(value) / std::sqrt(6.0) * Complex(a, b);
  };
  const auto name = [](std::size_t part, std::size_t coordinate) {
    return frf::Dof::parse(std::to_string(10 * part + coordinate / 2 + 1) + (coordinate % 2 == 0 ? ":+Y" : ":+RZ"));
  };
  frf::FrfSet assembly;
  assembly.header.file = "assembly";
  for (std::size_t line = 0; line < 16; ++line) assembly.header.frequency_hz.push_back(30.0 + 20.0 * double(line));
  std::vector<std::pair<std::size_t, std::size_t>> forces;
  for (std::size_t part = 0; part < chain.parts(); ++part) {
    frf::FrfSet own;
    own.header.file = "part " + std::to_string(part);
    own.header.frequency_hz = assembly.header.frequency_hz;
    for (std::size_t c = 0; c < 6; ++c) {
      own.header.response.push_back(name(part, c));
      own.header.reference.push_back(name(part, c));
      assembly.header.response.push_back(name(part, c));
      if (c < 2 || c > 3 || part == 0) {
        forces.emplace_back(part, c);
        assembly.header.reference.push_back(name(part, c));
      }
    }
    for (const double hz : own.header.frequency_hz) {
      const BeamChain::Complex6 h = chain.free_frfs(part, 2.0 * 3.141592653589793 * hz);
      for (Eigen::Index r = 0; r < 6; ++r) {
        for (Eigen::Index c = 0; c < 6; ++c) own.values.push_back(noisy(h(r, c), parts_level));
      }
    }
    out.substructures.push_back(std::move(own));
  }
  for (const double hz : assembly.header.frequency_hz) {
    const Eigen::MatrixXcd h = chain.chain_frfs(2.0 * 3.141592653589793 * hz, forces);
    for (Eigen::Index r = 0; r < h.rows(); ++r) {
      for (Eigen::Index c = 0; c < h.cols(); ++c) assembly.values.push_back(noisy(h(r, c), level));
    }
  }
  out.assembly = {std::move(assembly)};
  std::string joints;
  for (std::size_t e = 0; e < 10; ++e) {
    const auto [k11, k12, k22, d11, d12, d22] = nominal.joint(e);
    const auto matrix = [](double a, double b, double c) {
      const auto text = [](double value) { return std::to_string(value); };
      const auto row = [&](double x, double y, double sign) {
        return text(sign * x) + "," + text(sign * y) + "," + text(-sign * x) + "," + text(-sign * y);
      };
      return "{ matrix = [[" + row(a, b, 1) + "],[" + row(b, c, 1) + "],[" + row(a, b, -1) + "],[" + row(b, c, -1) + "]] }";
    };
    joints += "[[joints]]\nname = 'j" + std::to_string(e) + "'\ndofs = ['" + std::to_string(10 * e + 3) + ":+Y', '" +
              std::to_string(10 * e + 3) + ":+RZ', '" + std::to_string(10 * e + 11) + ":+Y', '" + std::to_string(10 * e + 11) +
              ":+RZ']\nstiffness = " + matrix(k11, k12, k22) + "\nhysteretic_damping = " + matrix(d11, d12, d22) + "\n";
  }
  out.scene = parse_scene(
      "data = { substructures = ['a.h5'], assembly = ['b.h5'] }\nidentify = { method = 'one', loose = true }\n" + joints,
      "s.toml");
  return out;
}

TEST(Loose, SensorsAtAllJointsNameThem) {
  for (const double level : {0.01, 0.05}) {
    int named = 0;
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Solution found = solve(*loose_chain(level, seed, level).plan());
      ASSERT_EQ(found.loose.size(), 10u);
      EXPECT_EQ(found.unknowns[5].name, "j5.K.share");
      const std::set<std::string> first = {found.loose[0].joint, found.loose[1].joint};
      named += first == std::set<std::string>{"j5", "j8"} && found.loose[1].probability > 0.9 && found.loose[2].probability < 0.5;
    }
    EXPECT_GE(named, 19) << level;
  }
}

/// Undamped eigenfrequencies of a chain of ten joints with shares of its nominal stiffness, Hz.
Eigen::VectorXd eigenfrequencies(const std::vector<double>& shares) {
  BeamChain chain;
  chain.joints = shares.size();
  for (const double share : shares) chain.lost.push_back(1.0 - share);
  const auto n = 6 * Eigen::Index(chain.parts());
  Eigen::MatrixXd k = Eigen::MatrixXd::Zero(n, n), m = k;
  for (std::size_t s = 0; s < chain.parts(); ++s) {
    const Eigen::Index first = 6 * Eigen::Index(s);
    const auto [stiff, mass] = chain.beam(s);
    k.block<6, 6>(first, first) += stiff;
    m.block<6, 6>(first, first) += mass;
    if (s == chain.joints) continue;
    const Eigen::Matrix2d x = chain.impedance(s).real();
    k.block<2, 2>(first + 4, first + 4) += x;
    k.block<2, 2>(first + 6, first + 6) += x;
    k.block<2, 2>(first + 4, first + 6) -= x;
    k.block<2, 2>(first + 6, first + 4) -= x;
  }
  return dense::symmetric_eigen(k, m).values.cwiseMax(0.0).cwiseSqrt() / (2.0 * 3.141592653589793);
}

std::vector<double> values_of(const Solution& solution) {
  std::vector<double> out;
  for (const Estimate& each : solution.unknowns) out.push_back(each.value);
  return out;
}

TEST(Frequencies, AreThoseOfTheJointThatIsFound) {
  MemoryScene noisy = loose_chain(0.05, 2, 0.0);
  const std::vector<double> truth = {1, 1, 1, 1, 1, 0.4, 1, 1, 0.2, 1};
  const Eigen::VectorXd exact = eigenfrequencies(truth);
  const auto error = [&](const std::vector<double>& shares) {
    double sum = 0.0;
    for (std::size_t e = 0; e < shares.size(); ++e) sum += std::pow(shares[e] - truth[e], 2);
    return std::sqrt(sum);
  };
  std::vector<Eigen::Index> modes;
  for (Eigen::Index mode = 0; mode < exact.size() && modes.size() < 4; ++mode) {
    if (exact[mode] > 60.0 && exact[mode] < 320.0) modes.push_back(mode);
  }
  ASSERT_EQ(modes.size(), 4u);
  const std::vector<double> free = values_of(solve(*noisy.plan()));
  for (const Eigen::Index mode : modes) noisy.scene.identify.frequencies_hz.push_back(exact[mode]);
  const Solution found = solve(*noisy.plan());
  EXPECT_EQ(found.status, Status::ok) << found.message;
  EXPECT_EQ(found.admissibility->equations, 4u);
  const std::vector<double> held = values_of(found);
  EXPECT_LT(error(held), error(free));
  for (const Eigen::Index mode : modes) {
    const double before = std::abs(eigenfrequencies(free)[mode] / exact[mode] - 1.0);
    const double after = std::abs(eigenfrequencies(held)[mode] / exact[mode] - 1.0);
    EXPECT_LT(after, std::max(0.2 * before, 2e-3)) << exact[mode] << " Hz, before " << before;
  }
  const auto refused = [&](auto change) -> std::string {
    MemoryScene other = noisy;
    change(other.scene.identify);
    try {
      other.plan();
    } catch (const InputError& error_found) {
      return error_found.what();
    }
    return "no error";
  };
  EXPECT_THAT(refused([](IdentifySection& identify) { identify.frequencies_hz = {5.0}; }),
              HasSubstr("5 Hz is outside the lines of the substructures"));
  EXPECT_THAT(refused([](IdentifySection& identify) { identify.method = Method::likelihood; }), HasSubstr("use method \"one\""));
}

TEST(Loose, TakesANominalStiffnessByNumbers) {
  const auto parsed = [](const std::string& stiffness) {
    return parse_scene(
        "data = { substructures = ['a.h5'], assembly = ['b.h5'] }\njoint = { dofs = ['4:+Y', '5:+Y'], stiffness = { " +
            stiffness + " } }\nidentify = { loose = true, passive = [10.0, 400.0], inequalities = ['K.share <= 1'] }\n",
        "s.toml");
  };
  const Scene scene = parsed("matrix = [[2e6, -2e6], [-2e6, 2e6]]");
  EXPECT_EQ(std::get<std::string>(std::get<restrictions::EntryMatrix>(scene.joints[0].matrices.at(Kind::stiffness))[0][1]),
            "-2e+06*share");
  EXPECT_TRUE(scene.joints[0].matrices.contains(Kind::hysteretic_damping));
  EXPECT_EQ(scene.identify.passive_hz, (Range{10.0, 400.0}));
  try {
    parsed("pattern = 'symmetric'");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the stiffness of the joint is not given by numbers"));
    EXPECT_THAT(error.what(), HasSubstr("or leave loose out"));
  }
}

}  // namespace
}  // namespace jointid::ident
