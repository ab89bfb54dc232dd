#include <gmock/gmock.h>

#include <Eigen/Core>
#include <limits>

#include "base/error.hpp"
#include "ident/admissible/admissible_set.hpp"
#include "ident/admissible/constraint_phrases.hpp"
#include "ident/equations/assemble.hpp"
#include "ident/scene/read_scene.hpp"
#include "joint_eigenvalues.hpp"
#include "minimise/linear/reduced_system.hpp"
#include "study/trial_loop.hpp"
#include "tests/ident/likelihood_case.hpp"

namespace jointid::ident {
namespace {

using restrictions::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::set<Kind> both = {Kind::stiffness, Kind::hysteretic_damping};

/// A built-in problem for Method One with its noise at 5 %.
struct LinearCase : LikelihoodCase {
  explicit LinearCase(const std::string& name) : LikelihoodCase(name) { scene.identify.method = Method::one; }
};

double cost_of(const Admissibility& found) {
  double sum = 0.0;
  for (const ConstraintOutcome& each : found.constraints) sum += each.chi_square;
  return sum;
}

template <class Case>
std::string error_of(const Case& of) {
  try {
    of.clean();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(AdmissibleLinear, DefiniteMatricesHaveNoNegativeEigenvalue) {
  for (const char* solver : {"qr", "normal", "spqr"}) {
    LinearCase a1("A1");
    a1.scene.identify.solver = parse_solver(solver);
    const Solution free = solve(*a1.polluted());
    ASSERT_LT(least_relative_eigenvalue(free), -1e-6);  // the joint has no stiffness against rigid motion
    EXPECT_FALSE(free.admissibility);
    a1.scene.joints[0].definite = both;
    const Solution found = solve(*a1.polluted());
    EXPECT_EQ(found.status, Status::ok);
    EXPECT_GE(least_relative_eigenvalue(found), -1e-10) << solver;
    EXPECT_GT(found.admissibility->chi_square, 0.0);
    EXPECT_NEAR(cost_of(*found.admissibility), found.admissibility->chi_square, 1e-4 * found.admissibility->chi_square);
    EXPECT_GT(found.admissibility->equations, 0u);
    EXPECT_THAT(found.unknowns[0].limit + found.unknowns[19].limit, HasSubstr("is singular"));
  }
}

/// The condition of a joint is one of its own unknowns, wherever its coordinates stand among those of all joints.
TEST(AdmissibleLinear, EveryOneOfManyJointsIsDefinite) {
  LinearCase chain("chain-50");
  chain.scene.identify.equations.clear();
  const Solution free = solve(*chain.polluted());
  ASSERT_LT(least_relative_eigenvalue(free), -1e-6);
  for (restrictions::JointSpec& joint : chain.scene.joints) joint.definite = both;
  const auto plan = chain.polluted();
  ASSERT_EQ(plan->admissible->inequalities.size(), 2 * chain.scene.joints.size());
  const auto& unknowns = chain.problem.unknowns;
  for (const Inequality& inequality : plan->admissible->inequalities) {
    const std::string joint = inequality.text.substr(0, inequality.text.find('.') + 1);
    ASSERT_FALSE(inequality.block.unknowns.empty());
    for (const Eigen::Index u : inequality.block.unknowns)
      EXPECT_THAT(unknowns[static_cast<std::size_t>(u)].name, testing::StartsWith(joint)) << inequality.text;
  }
  EXPECT_GE(least_relative_eigenvalue(solve(*plan)), -1e-9);
}

/// The admissible joints are convex and the truth is one of them: in the metric of the projection it cannot come to lie further
/// off.
TEST(AdmissibleLinear, TheProjectionIsNoFurtherFromTheTruth) {
  LinearCase a1("A1");
  a1.scene.joints[0].definite = both;
  const auto plan = a1.polluted();
  RunTime runtime;
  Assembled system = assemble(*plan, runtime);
  const minimise::LinearSolution free = solve(*plan, system.accumulator);
  const Eigen::MatrixXd root = minimise::reduced_system(system.accumulator).leftCols(20);
  const Solution found = solve(*plan);
  Eigen::VectorXd before(20), after(20);
  for (std::size_t u = 0; u < 20; ++u) {
    const auto i = static_cast<Eigen::Index>(u);
    before[i] = free.y[u] - a1.problem.unknowns[u].value / plan->unscale(u);
    after[i] = (found.unknowns[u].value - a1.problem.unknowns[u].value) / plan->unscale(u);
  }
  EXPECT_LT((root * after).norm(), (root * before).norm());
}

TEST(AdmissibleLinear, ExactDataOfASingularJointGiveTheTruth) {
  LinearCase a1("A1");
  a1.scene.joints[0].definite = both;
  const Solution found = solve(*a1.clean());
  EXPECT_EQ(found.status, Status::ok);
  for (std::size_t u = 0; u < found.unknowns.size(); ++u) {
    const double truth = a1.problem.unknowns[u].value;
    EXPECT_NEAR(found.unknowns[u].value, truth, 1e-7 * std::abs(truth)) << found.unknowns[u].name;
  }
}

TEST(AdmissibleLinear, AConstraintThatHoldsAnywayChangesNoBit) {
  LinearCase a1("A1");
  const Solution free = solve(*a1.polluted());
  a1.scene.identify.bounds = {{"K(1,1)", 0.0, 1e9}, {"D(1,1)", -1e9, 1e9}};
  const Solution found = solve(*a1.polluted());
  for (std::size_t u = 0; u < free.unknowns.size(); ++u) EXPECT_EQ(found.unknowns[u].value, free.unknowns[u].value);
  EXPECT_EQ(found.admissibility->chi_square, 0.0);
  EXPECT_EQ(found.admissibility->equations, 0u);
  EXPECT_EQ(found.unknowns[0].limit, "");
}

/// The same equation by a bound that is hit, by a tie, and by a known number in the pattern.
TEST(AdmissibleLinear, ABoundATieAndAKnownElementAgree) {
  LinearCase a1("A1");
  const double value = 0.9 * solve(*a1.polluted()).unknowns[0].value;
  LinearCase bounded = a1, tied = a1, known = a1;
  bounded.scene.identify.bounds = {{"K(1,1)", -1e9, value}};
  tied.scene.identify.ties = {"K(1,1) = " + std::to_string(value)};
  known.scene.joints[0].matrices[Kind::stiffness] = restrictions::EntryMatrix{
      {std::stod(std::to_string(value)), "b", "c", "d"}, {"b", "e", "f", "g"}, {"c", "f", "h", "i"}, {"d", "g", "i", "j"}};
  const Solution by_bound = solve(*bounded.polluted()), by_tie = solve(*tied.polluted()), by_number = solve(*known.polluted());
  for (std::size_t u = 1; u < 20; ++u) {
    const double expected = by_number.unknowns[u - 1].value;
    EXPECT_NEAR(by_tie.unknowns[u].value, expected, 1e-7 * std::abs(expected));
    EXPECT_NEAR(by_bound.unknowns[u].value, expected, 1e-4 * std::abs(expected));
  }
  EXPECT_EQ(by_bound.unknowns[0].limit, "at its upper bound");
  EXPECT_EQ(by_tie.unknowns[0].limit, "tied");
  EXPECT_NEAR(by_bound.admissibility->chi_square, by_tie.admissibility->chi_square, 1e-4 * by_tie.admissibility->chi_square);
  EXPECT_EQ(by_bound.admissibility->equations, 1u);
  EXPECT_EQ(by_tie.fit.rank, 20u);
}

TEST(AdmissibleLinear, TiesFixWhatTheDataLeaveFree) {
  LinearCase a1("A1");
  a1.scene.joints[0].matrices[Kind::mass] = restrictions::Pattern::symmetric;
  a1.scene.frequency.range_hz = Range{400.0, 400.0};  // one line: K − ω²M only
  const Solution free = solve(*a1.clean());
  ASSERT_EQ(free.status, Status::rank_deficient);
  for (int i = 1; i <= 4; ++i) {
    for (int j = i; j <= 4; ++j) a1.scene.identify.ties.push_back("M(" + std::to_string(i) + "," + std::to_string(j) + ") = 0");
  }
  const Solution found = solve(*a1.clean());
  EXPECT_EQ(found.status, Status::ok) << found.message;
  EXPECT_NEAR(found.unknowns[0].value, a1.problem.unknowns[0].value, 1e-5 * a1.problem.unknowns[0].value);
}

TEST(AdmissibleLikelihood, DefiniteMatricesAndWhatTheyCost) {
  LikelihoodCase a1("A1");
  const Solution free = solve(*a1.polluted(2));
  ASSERT_LT(least_relative_eigenvalue(free), -1e-6);
  a1.scene.joints[0].definite = both;
  const Solution found = solve(*a1.polluted(2));
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_GE(least_relative_eigenvalue(found), -1e-10);
  // No line is outlying here: the loss is χ².
  EXPECT_GT(found.admissibility->chi_square, 0.0);
  EXPECT_NEAR(found.fit.chi_square->value - free.fit.chi_square->value, found.admissibility->chi_square, 0.02);
  EXPECT_NEAR(cost_of(*found.admissibility), found.admissibility->chi_square, 1e-6 * found.admissibility->chi_square);
  EXPECT_TRUE(found.admissibility->from_variances);
}

TEST(AdmissibleLikelihood, ABoundAndAKnownElementAgree) {
  LikelihoodCase c2("C2", 0.01);
  const Solution free = solve(*c2.polluted());
  const double value = free.unknowns[0].value - 4.0 * *free.unknowns[0].std_error;
  LikelihoodCase bounded = c2, known = c2;
  bounded.scene.identify.bounds = {{"K(1,1)", 0.0, value}};
  known.scene.joints[0].matrices[Kind::stiffness] =
      restrictions::EntryMatrix{{value, "b", "c", "d"}, {"b", "e", "f", "g"}, {"c", "f", "h", "i"}, {"d", "g", "i", "j"}};
  const Solution by_bound = solve(*bounded.polluted()), by_number = solve(*known.polluted());
  ASSERT_EQ(by_bound.status, Status::doubtful);
  for (std::size_t u = 1; u < by_bound.unknowns.size(); ++u) {
    EXPECT_NEAR(by_bound.unknowns[u].value, by_number.unknowns[u - 1].value, 0.02 * *by_number.unknowns[u - 1].std_error);
  }
  EXPECT_NEAR(by_bound.admissibility->chi_square, by_number.fit.chi_square->value - free.fit.chi_square->value,
              1.0);                                            // variances follow the values there
  EXPECT_NEAR(by_bound.admissibility->chi_square, 16.0, 2.0);  // four standard deviations
  EXPECT_LE((*by_bound.unknowns[0].ci95)[1], value);
  EXPECT_THAT(by_bound.message, HasSubstr("The data contradict the constraints"));
}

TEST(AdmissibleStudy, EveryTrialIsAdmissible) {
  LinearCase a1("A1");
  a1.scene.joints[0].definite = both;
  const auto plan = a1.polluted();
  const std::vector<study::Trial> trials =
      study::run_trials(problems::trial_data(a1.scene, a1.problem), {.trials = 5, .threads = 1});
  for (const study::Trial& trial : trials) {
    for (const Kind kind : both) EXPECT_GE(least_relative_eigenvalue(plan->restriction.matrix(kind, trial.values)), -1e-10);
  }
}

TEST(AdmissiblePlan, TellsTheConstraints) {
  LinearCase a1("A1");
  EXPECT_FALSE(a1.clean()->admissible);
  EXPECT_THAT(constraint_phrases(*a1.clean()), ElementsAre());
  a1.scene.joints[0].definite = {Kind::stiffness};
  a1.scene.identify.bounds = {{"D(1,1)", 0.0, 50.0}};
  a1.scene.identify.ties = {"K(1,1) = K(3,3)"};
  EXPECT_THAT(constraint_phrases(*a1.clean()),
              ElementsAre("K(1,1) = K(3,3)", "K positive semidefinite", "D(1,1) >= 0", "D(1,1) <= 50 N/m"));
}

TEST(AdmissiblePlan, RefusesWhatCannotBe) {
  const auto refused = [](auto change) {
    LinearCase a1("A1");
    change(a1.scene);
    return error_of(a1);
  };
  const auto definite = [](restrictions::MatrixSpec spec) {
    return [spec](Scene& scene) {
      scene.joints[0].matrices[Kind::stiffness] = spec;
      scene.joints[0].definite = {Kind::stiffness};
    };
  };
  using restrictions::EntryMatrix;
  EXPECT_THAT(refused(definite(restrictions::Pattern::full)), HasSubstr("[joint.stiffness] definite: only a symmetric matrix"));
  // A zero on the diagonal.
  EXPECT_THAT(
      refused(definite(EntryMatrix{{0.0, "a", 0.0, 0.0}, {"a", "b", 0.0, 0.0}, {0.0, 0.0, "c", 0.0}, {0.0, 0.0, 0.0, "d"}})),
      HasSubstr("no joint has K positive semidefinite with room to spare"));
  // Known and negative.
  EXPECT_THAT(
      refused(definite(EntryMatrix{{-5.0, 0.0, 0.0, 0.0}, {0.0, "b", 0.0, 0.0}, {0.0, 0.0, "c", 0.0}, {0.0, 0.0, 0.0, "d"}})),
      HasSubstr("no joint has K positive semidefinite"));
  EXPECT_EQ(
      refused(definite(EntryMatrix{{5e5, "b", 0.0, 0.0}, {"b", 4e3, 0.0, 0.0}, {0.0, 0.0, "c", 0.0}, {0.0, 0.0, 0.0, "d"}})),
      "no error");
  EXPECT_THAT(refused([](Scene& scene) {
                scene.joints[0].definite = {Kind::stiffness};
                scene.identify.bounds = {{"K(2,2)", -std::numeric_limits<double>::infinity(), -10.0}};
              }),
              HasSubstr("no joint meets these together with room to spare: K positive semidefinite, K(2,2) <= -10 "));
  EXPECT_THAT(refused([](Scene& scene) {
                scene.identify.bounds = {{"K(1,9)", 0.0, 1.0}};
              }),
              HasSubstr("[identify] bounds: the joint has no unknown K(1,9); did you mean K(1,1)?"));
  EXPECT_THAT(refused([](Scene& scene) { scene.identify.ties = {"K(1,1) = K(1,9)"}; }),
              HasSubstr("[identify] ties: the tie 'K(1,1) = K(1,9)'"));
  EXPECT_THAT(refused([](Scene& scene) { scene.identify.ties = {"K(1,1) = 1", "K(1,1) = 2"}; }), HasSubstr("contradict"));
  EXPECT_THAT(refused([](Scene& scene) {
                scene.identify.method = Method::likelihood;
                scene.identify.solver = Solver::iqml;
                scene.identify.bounds = {{"K(1,1)", 0.0, 1.0}};
              }),
              HasSubstr("solver \"iqml\" knows no constraints"));
}

TEST(AdmissiblePlan, ReadsTheKeysOfTheScene) {
  const auto parsed = [](const std::string& text) {
    return parse_scene(
        "data = { substructures = ['a.h5'], assembly = ['b.h5'] }\njoint = { dofs = ['4:+Y', '5:+Y'], "
        "stiffness = { pattern = 'symmetric', definite = true }, mass = { pattern = 'diagonal', definite = false } }\n" +
            text,
        "s.toml");
  };
  const Scene scene = parsed(
      "identify = { bounds = { 'K(1,1)' = [1, inf], 'M(1,1)' = 'positive', 'M(2,2)' = 'negative' }, ties = ['K(1,1) = K(2,2)'] "
      "}");
  EXPECT_THAT(scene.joints[0].definite, ElementsAre(Kind::stiffness));
  ASSERT_EQ(scene.identify.bounds.size(), 3u);
  EXPECT_EQ(scene.identify.bounds[0].lower, 1.0);
  EXPECT_TRUE(std::isinf(scene.identify.bounds[0].upper));
  EXPECT_EQ(scene.identify.bounds[2].upper, 0.0);
  EXPECT_THAT(scene.identify.ties, ElementsAre("K(1,1) = K(2,2)"));
  for (const char* wrong : {"[1]", "[2, 1]", "[1, 1]", "[-inf, inf]", "[nan, 1]", "'big'", "[inf, inf]", "3"}) {
    EXPECT_THROW(parsed("identify = { bounds = { 'K(1,1)' = " + std::string(wrong) + " } }"), InputError) << wrong;
  }
  EXPECT_THROW(parsed("identify = { ties = [] }"), InputError);
  EXPECT_THROW(parsed("identify = { ties = [3] }"), InputError);
}

/// Positions in the files of the assembly alone, and a joint that is definite and free at once.
TEST(AdmissiblePlan, FreeJointsTakePositionsFromAnyFile) {
  LinearCase a1("A1");
  auto noisy = problems::polluted(a1.problem, 1, 0);
  ASSERT_FALSE(noisy.assembly.header.nodes.empty());
  for (frf::FrfSet& set : noisy.substructures) set.header.nodes.clear();
  for (const Kind kind : both) a1.scene.joints[0].matrices[kind] = restrictions::Pattern::free;
  a1.scene.joints[0].definite = both;
  const auto plan = problems::plan(a1.scene, noisy);
  const Solution found = solve(*plan);
  EXPECT_EQ(found.unknowns.size(), 6u);  // a beam element deforms in two ways
  EXPECT_GE(least_relative_eigenvalue(found), -1e-10);
}

}  // namespace
}  // namespace jointid::ident
