#include "ident/plan/couple_first.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "study/trial_runner.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"

namespace jointid::ident {
namespace {

using restrictions::EntryMatrix;
using restrictions::Kind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Scene scene_with(const std::string& joint, const std::string& rest = "") {
  return parse_scene("[data]\nsubstructures = [\"a.h5\"]\nassembly = [\"b.h5\"]\n[joint]\n" + joint + rest, "scene.toml");
}

std::string error_of(const std::string& joint) {
  try {
    scene_with(joint);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const std::string four = "dofs = [\"4:+Y\", \"5:+Y\", \"4:+RZ\", \"5:+RZ\"]\n";
const std::string rotations = "couple_first = [[\"4:+RZ\", \"5:+RZ\"]]\n";

TEST(CoupleFirst, ARigidJointWithoutMassLeavesTheOthers) {
  const Scene scene =
      scene_with(four + rotations +
                     "[joint.stiffness]\nmatrix = [[\"a\",\"b\",0,0],[\"b\",\"c\",0,0],[0,0,\"d\",\"e\"],[0,0,\"e\",\"f\"]]\n",
                 "[truth]\nstiffness = [[1,-1,0,0],[-1,2,0,0],[0,0,9,-9],[0,0,-9,9]]\n");
  ASSERT_EQ(scene.joints.size(), 1u);
  EXPECT_THAT(names(scene.joints[0].dofs), ElementsAre("4:+Y", "5:+Y"));
  EXPECT_THAT(names(scene.couple_first.hidden), ElementsAre("4:+RZ"));
  EXPECT_EQ(restrictions::build(scene.joints).unknowns.size(), 3u);
  EXPECT_THAT(scene.truth.at(Kind::stiffness), ElementsAre(ElementsAre(1, -1), ElementsAre(-1, 2)));
}

TEST(CoupleFirst, SpringsBetweenThePairAreDropped) {
  const Scene scene = scene_with(four + rotations + "[joint.stiffness]\nsprings = [[\"4:+Y\",\"5:+Y\"], [\"4:+RZ\",\"5:+RZ\"]]\n");
  EXPECT_THAT(names(scene.joints[0].dofs), ElementsAre("4:+Y", "5:+Y"));
  EXPECT_EQ(restrictions::build(scene.joints).unknowns.size(), 1u);
}

TEST(CoupleFirst, WithMassThePairStaysOnceAndItsEntriesAreSummed) {
  const Scene scene = scene_with(four + rotations + "[joint.stiffness]\nsprings = [[\"4:+Y\",\"5:+Y\"]]\n[joint.mass]\n"
                                 "matrix = [[0,0,0,0],[0,0,0,0],[0,0,\"m\",0.5],[0,0,0.5,\"2*m\"]]\n",
                                 "[truth]\nmass = [[0,0,0,0],[0,0,0,0],[0,0,1,0.5],[0,0,0.5,2]]\n");
  EXPECT_THAT(names(scene.joints[0].dofs), ElementsAre("4:+Y", "5:+Y", "4:+RZ"));
  EXPECT_TRUE(scene.couple_first.hidden.empty());
  EXPECT_EQ(scene.truth.at(Kind::mass)[2][2], 4.0);
  const auto mass = restrictions::build(scene.joints).matrix(Kind::mass, {0.0, 1.0});  // m = 1
  EXPECT_DOUBLE_EQ(mass[8], 4.0);
}

TEST(CoupleFirst, APatternHoldsForTheCoordinatesThatAreLeft) {
  const Scene scene = scene_with(four + rotations + "[joint.stiffness]\npattern = \"symmetric\"\n");
  EXPECT_THAT(names(scene.joints[0].dofs), ElementsAre("4:+Y", "5:+Y", "4:+RZ"));
  EXPECT_EQ(restrictions::build(scene.joints).unknowns.size(), 6u);
}

TEST(CoupleFirst, SignsOfThePairTurnWhatIsLeft) {
  const Scene scene = scene_with(
      "dofs = [\"4:+Y\", \"6:+Y\"]\ncouple_first = [[\"3:+Y\", \"4:-Y\"]]\n[joint.stiffness]\nmatrix = "
      "[[\"a\",\"b\"],[\"b\",\"c\"]]\n",
      "[truth]\nstiffness = [[1,2],[2,3]]\n");
  EXPECT_THAT(names(scene.joints[0].dofs), ElementsAre("3:-Y", "6:+Y"));  // x_4 = −x_3
  EXPECT_THAT(scene.truth.at(Kind::stiffness), ElementsAre(ElementsAre(1, 2), ElementsAre(2, 3)));
}

TEST(CoupleFirst, SaysWhatIsWrong) {
  const std::string spring = "[joint.stiffness]\nsprings = [[\"4:+RZ\",\"5:+RZ\"]]\n";
  EXPECT_THAT(error_of("dofs = [\"4:+RZ\", \"5:+RZ\"]\n" + rotations + spring), HasSubstr("nothing is left to identify"));
  EXPECT_THAT(error_of(four + "couple_first = [[\"4:+RZ\"]]\n" + spring), HasSubstr("a pair has two DOFs"));
  EXPECT_THAT(error_of(four + "couple_first = [[\"4:+RZ\", \"5:+RZ\"], [\"4:+RZ\", \"5:-RZ\"]]\n" + spring),
              HasSubstr("contradicts itself"));
}

/// A case G with noise on A and B before they are coupled.
struct CaseG {
  problems::Problem problem;

  explicit CaseG(const std::string& name) : problem(problems::make(name)) {}

  Scene scene(Method method, const std::string& line = "") const {
    std::string text = problem.scene;
    const std::string joint = "[joint]\n";
    text.insert(text.find(joint) + joint.size(), line);
    Scene out = parse_scene(text, "G.toml");
    out.identify.method = method;
    return out;
  }

  Solution solution(const Scene& scene, std::uint64_t seed) const {
    return solve(*problems::plan(scene, problems::polluted(problem, seed, 0)));
  }
};

/// Of the first three unknowns, the translational spring's.
double largest_error(const Solution& solution) {
  constexpr std::array<double, 3> exact = {662400.0, -662400.0, 662400.0};
  double worst = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i) worst = std::max(worst, std::abs(solution.unknowns.at(i).value / exact[i] - 1.0));
  return worst;
}

/// The line that the findings propose for [joint], or nothing.
std::string proposed_line(const Solution& solution) {
  for (const Finding& finding : solution.identifiability->findings) {
    const std::size_t at = finding.text.find("couple_first = ");
    if (finding.kind == FindingKind::stiff_joint && at != std::string::npos) {
      return finding.text.substr(at, finding.text.rfind('.') - at) + "\n";
    }
  }
  return "";
}

TEST(CoupleFirst, WithoutNoiseTheCoupledPartsAreTheTiedStructure) {
  const CaseG g("G1");
  const problems::Problem tied = problems::make("G4");  // A and B with the rotations tied in their matrices
  const auto plan = problems::plan(g.scene(Method::one, rotations), {g.problem.substructures, g.problem.assembly});
  const frf::FrfSet& expected = tied.substructures.front();
  EXPECT_EQ(plan->substructures->responses().size(), expected.header.response.size());
  frf::BlockReader reader(*plan->substructures, expected.header.response, expected.header.reference);
  for (const std::size_t line : {std::size_t{0}, std::size_t{10}, std::size_t{20}}) {
    std::vector<Complex> values(expected.header.entries());
    reader.read({&line, 1}, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Complex exact = expected.values[line * values.size() + i];
      ASSERT_LT(std::abs(values[i] - exact), 1e-9 * std::abs(exact)) << line << " " << i;
    }
  }
}

TEST(CoupleFirst, TheProposedLineFindsTheJointThatAStiffOneSpoils) {
  const CaseG g("G6");
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    EXPECT_GT(largest_error(g.solution(g.scene(Method::one), seed)), 0.5) << "seed " << seed;
    const Solution uncoupled = g.solution(g.scene(Method::likelihood), seed);
    EXPECT_LT(largest_error(uncoupled), 0.03) << "seed " << seed;  // the likelihood does not need the line, and knows what it cannot see:
    EXPECT_GT(uncoupled.unknowns.at(3).std_error.value() / uncoupled.unknowns.at(3).value, 0.1) << "seed " << seed;
    const std::string line = proposed_line(uncoupled);
    ASSERT_EQ(line, "couple_first = [[\"4:+RZ\", \"5:+RZ\"]]\n");
    EXPECT_LT(largest_error(g.solution(g.scene(Method::one, line), seed)), 0.1) << "seed " << seed;
    const Solution coupled = g.solution(g.scene(Method::likelihood, line), seed);
    EXPECT_LT(largest_error(coupled), 0.03) << "seed " << seed;
    EXPECT_EQ(coupled.unknowns.size(), 3u);
    EXPECT_EQ(proposed_line(coupled), "");
    EXPECT_TRUE(uncoupled.warnings.empty());
    EXPECT_TRUE(coupled.warnings.empty());
  }
}

/// Errors of the parts spread over all FRFs that are coupled of them: with their variances alone 24 of these 36 intervals hold.
TEST(CoupleFirst, IntervalsKnowWhatCoupledErrorsHaveInCommon) {
  const CaseG g("G6");
  const Scene scene = g.scene(Method::likelihood, rotations);
  constexpr std::array<double, 3> exact = {662400.0, -662400.0, 662400.0};
  std::size_t inside = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Solution solution = g.solution(scene, seed);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const auto& interval = solution.unknowns.at(i).ci95;
      inside += interval && (*interval)[0] <= exact[i] && exact[i] <= (*interval)[1] ? 1U : 0U;
    }
  }
  EXPECT_GE(inside, 31u);
}

TEST(CoupleFirst, VariancesThatTheScatterTellsAreTakenForIndependent) {
  const CaseG g("G6");
  Scene scene = g.scene(Method::likelihood, rotations);
  scene.identify.variance = VarianceChoice::local;
  scene.noise.reset();
  const auto plan = problems::plan(scene, problems::polluted(g.problem, 1, 0));
  EXPECT_FALSE(plan->method->carries_shared_errors());
  EXPECT_THAT(solve(*plan).warnings, ::testing::Contains(HasSubstr("those of the FRFs of the coupled parts are not")));
}

TEST(CoupleFirst, StudiesCoupleTheNoisyParts) {
  const CaseG g("G6");
  const Scene scene = g.scene(Method::one, rotations);
  const auto data = problems::trial_data(scene, g.problem);
  EXPECT_EQ(data->base.substructures.size(), 2u);
  study::TrialRunner runner(data);
  const study::Trial trial = runner.run(1, 0);
  const Solution direct = g.solution(scene, 1);
  ASSERT_EQ(trial.values.size(), direct.unknowns.size());
  for (std::size_t i = 0; i < trial.values.size(); ++i) {
    EXPECT_NEAR(trial.values[i], direct.unknowns[i].value, 1e-9 * std::abs(direct.unknowns[i].value));
  }
}

}  // namespace
}  // namespace jointid::ident
