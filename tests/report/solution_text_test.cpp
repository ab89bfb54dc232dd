#include "report/result/solution_text.hpp"

#include <gmock/gmock.h>

#include "report/text/joints_text.hpp"
#include "solution_sample.hpp"

namespace jointid::report {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(SolutionText, MatricesCarryTheirDofs) {
  EXPECT_THAT(solution_text(sample_solution(), "two beams"),
              HasSubstr("stiffness K (SI units)\n"
                        "          4:+Y  4:+RZ\n"
                        "  4:+Y   1e+06      5\n"
                        "  4:+RZ      5     20\n"));
}

TEST(SolutionText, StatusMessageAndWhatWasUsedComeFirst) {
  EXPECT_THAT(solution_text(sample_solution(), "two beams"),
              StartsWith("two beams\n"
                         "  status   rank deficient\n"
                         "  message  k2 is not fixed by the data\n"
                         "  method   one, equations nn nj, weighting WBS, delta 0.05, solver qr\n"));
}

TEST(SolutionText, AnUnknownThatTheDataDoNotFixIsMarked) {
  const std::string text = solution_text(sample_solution(), "");
  EXPECT_THAT(text, HasSubstr("K(1,1)  1e+06  N/m        2000  990000 … 1.01e+06\n"));
  EXPECT_THAT(text, HasSubstr("not determined by the data\n"));
}

TEST(SolutionText, WithoutErrorsThereAreNoColumnsForThem) {
  auto solution = sample_solution();
  EXPECT_THAT(solution_text(solution, ""), HasSubstr("std error"));
  solution.unknowns.erase(solution.unknowns.begin());
  EXPECT_THAT(solution_text(solution, ""), Not(HasSubstr("std error")));
}

TEST(SolutionText, WithoutATruthThereIsNoQuality) {
  auto solution = sample_solution();
  EXPECT_THAT(solution_text(solution, ""), HasSubstr("against the truth"));
  solution.quality.clear();
  EXPECT_THAT(solution_text(solution, ""), Not(HasSubstr("against the truth")));
}

TEST(SolutionText, BandsSayWhereTheyHold) {
  auto solution = sample_solution();
  solution.bands[0].band_hz = {{100.0, 200.5}};
  EXPECT_THAT(solution_text(solution, ""), HasSubstr("stiffness K (SI units), 100 to 200.5 Hz\n"));
}

/// Twelve springs between 24 coordinates.
TEST(SolutionText, AWideMatrixOfSpringsIsNotPrinted) {
  ident::Solution solution = sample_solution();
  constexpr std::size_t springs = 12;
  solution.dofs.clear();
  ident::Matrix k(2 * springs, std::vector<double>(2 * springs, 0.0));
  for (std::size_t i = 0; i < 2 * springs; ++i) {
    solution.dofs.push_back({.node = static_cast<std::int64_t>(i + 1), .direction = frf::Direction::x});
    k[i][i] = 7e5;
    k[i][(i + springs) % (2 * springs)] = -7e5;
  }
  solution.bands.resize(1);
  solution.bands[0].matrices = {{restrictions::Kind::stiffness, k}};
  solution.bands[0].errors.clear();
  const std::string text = solution_text(solution, "");
  EXPECT_THAT(text, HasSubstr("stiffness K (SI units)\n"
                              "  24 × 24, mostly zeros: see the unknowns below; in full by --json and --report\n"));
  EXPECT_THAT(text, Not(HasSubstr("700000")));
  solution.bands[0].matrices.begin()->second.assign(2 * springs, std::vector<double>(2 * springs, 7e5));
  EXPECT_THAT(solution_text(solution, ""), HasSubstr("700000")) << "a full one";
}

TEST(SolutionText, OfALikelihoodHasItsOwnFiguresAndNoWeighting) {
  const std::string text = solution_text(sample_likelihood(), "");
  EXPECT_THAT(text, HasSubstr("likelihood, equations nn nj, solver gauss-helmert\n"));
  EXPECT_THAT(text, testing::ContainsRegex("iterations +9\n"));
  EXPECT_THAT(text, HasSubstr("812.2 / 800 = 1.015\n"));
  EXPECT_THAT(text, testing::ContainsRegex("outlier lines +2\n"));
  EXPECT_THAT(text, testing::AllOf(HasSubstr("a.uff  the law of [noise]\n"), HasSubstr("b.uff: too few lines\n")));
  EXPECT_THAT(text, Not(HasSubstr("condition")));
}

TEST(SolutionText, ConstraintsSayWhatHoldsAndWhatItCosts) {
  const std::string text = solution_text(sample_constrained(), "");
  EXPECT_THAT(text, ContainsRegex("K\\(1,1\\) .*K is singular"));
  EXPECT_THAT(text, ContainsRegex("K positive semidefinite +1 of 2 +12.5"));
  EXPECT_THAT(text, ContainsRegex("k2 >= 0 +no +0"));
  EXPECT_THAT(text, HasSubstr("χ² rises by 12.5, 3 equations hold"));
  EXPECT_THAT(solution_text(sample_solution(), ""), Not(HasSubstr("constraints")));
}

/// Neither 10,000 names nor a line for each of 501 files: the worst joints, those that the data do not determine first.
TEST(SolutionText, ManyJointsHaveALineEachAndTheWorstComeFirst) {
  const std::string text = solution_text(sample_of_many_joints(), "");
  EXPECT_LT(text.size(), 6000u);
  EXPECT_THAT(text, HasSubstr("500 joints, 10000 unknowns; 1 with unknowns that the data do not determine; the 20 worst"));
  EXPECT_THAT(text, ContainsRegex("j5 +20 .*2 not determined by the data"));
  EXPECT_THAT(text, ContainsRegex("j77 +20 .*j77\\.K\\(1,4\\) +50 %"));
  EXPECT_LT(text.find("j5 "), text.find("j77 "));
  EXPECT_THAT(text, HasSubstr("part_1.h5 and 500 more  the law of [noise]"));
  const std::vector<JointSummary> all = joint_summaries(sample_of_many_joints());
  ASSERT_EQ(all.size(), 500u);
  EXPECT_EQ(all[76].worst, "j77.K(1,4)");
  EXPECT_DOUBLE_EQ(all[76].worst_error, 0.5);
  EXPECT_DOUBLE_EQ(all[76].by_kind.at("K").largest, 1.9e6);
}

TEST(UnknownsCsv, EmptyWhereNotComputed) {
  EXPECT_EQ(unknowns_csv(sample_solution()),
            "name,value,unit,std_error,ci95_low,ci95_high,determined\n"
            "\"K(1,1)\",1000000,N/m,2000,990000,1010000,true\n"
            "k2,,N,,,,false\n");
}

}  // namespace
}  // namespace jointid::report
