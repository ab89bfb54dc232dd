#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/compare/compare_arguments.hpp"
#include "report/result/comparison_text.hpp"
#include "cli/problem/reproduction_text.hpp"
#include "comparison_sample.hpp"

namespace jointid::cli {
namespace {

using testing::HasSubstr;

std::string message(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

CompareArguments on_a_scene() {
  CompareArguments arguments;
  arguments.scene = "a.toml";
  return arguments;
}

TEST(CompareArguments, NameMethodsEquationSetsAndWeightings) {
  CompareArguments arguments = on_a_scene();
  arguments.methods = {"one", "two"};
  arguments.equations = "nn nj;nn,nj,jj";
  arguments.weightings = {"WBS"};
  const study::Alternatives lists = alternatives(arguments);
  EXPECT_EQ(lists.methods[1], ident::Method::two);
  ASSERT_EQ(lists.equations.size(), 2u);
  EXPECT_EQ(lists.equations[1].size(), 3u);
  EXPECT_EQ(lists.weightings[0], weighting::Weighting::wbs);
}

TEST(CompareArguments, WrongWordsNameTheOptionAndTheNearestWord) {
  CompareArguments arguments = on_a_scene();
  arguments.weightings = {"WBX"};
  EXPECT_THAT(message([&] { alternatives(arguments); }), testing::AllOf(HasSubstr("--weightings"), HasSubstr("did you mean WB")));
  arguments = on_a_scene();
  arguments.methods = {"tow"};
  EXPECT_THAT(message([&] { alternatives(arguments); }), testing::AllOf(HasSubstr("--methods"), HasSubstr("'two'")));
  arguments = on_a_scene();
  arguments.deltas = {2.0};
  EXPECT_THAT(message([&] { alternatives(arguments); }), HasSubstr("--deltas: 2 is outside"));
  for (const char* equations : {"nn nn", "nn;;nj", "nx"}) {
    arguments = on_a_scene();
    arguments.equations = equations;
    EXPECT_THAT(message([&] { alternatives(arguments); }), HasSubstr("--equations"));
  }
}

TEST(CompareArguments, NeedSomethingToCompareAndTrials) {
  EXPECT_THAT(message([] { check(CompareArguments()); }), HasSubstr("--reproduce"));
  CompareArguments arguments = on_a_scene();
  arguments.trials = 0;
  EXPECT_THAT(message([&] { check(arguments); }), HasSubstr("--trials"));
}

TEST(ComparisonText, HasTheThesisTableAndOneRowPerCombination) {
  const std::string text = report::comparison_text(sample_comparison());
  EXPECT_THAT(text, HasSubstr("7 trials of seed 3"));
  EXPECT_THAT(text, HasSubstr("  WBS  0.9876 1.0123  0.9876 1.0123\n"));
  EXPECT_THAT(text, testing::ContainsRegex("one +nn +WBS +0.05 +qr .*0.3 .*\\*\n"));
  EXPECT_THAT(text, HasSubstr("no such block"));
}

TEST(ComparisonText, OneDeltaNeedsNoTableOfDeltas) {
  tasks::ComparisonResult report = sample_comparison();
  report.comparison.combinations.pop_back();
  EXPECT_THAT(report::comparison_text(report), testing::Not(HasSubstr("medians of RJCF ARVF")));
}

TEST(ComparisonText, WaysLeftOutForOneReasonStandTogether) {
  tasks::ComparisonResult report = sample_comparison();
  auto& left_out = report.comparison.left_out;
  left_out.push_back(left_out.front());
  left_out.back().way.delta = 0.5;
  left_out.push_back({left_out.front().way, "another reason"});
  EXPECT_THAT(report::comparison_text(report),
              HasSubstr("left out\n  two all, 2 combinations: no such block\n  two all WB 0 qr: another reason\n"));
}

TEST(ComparisonJson, KeepsItsKeysAndHasNullForNoNumber) {
  const auto json = nlohmann::json::parse(report::comparison_json(sample_comparison()));
  const auto& second = json["combinations"][1];
  EXPECT_EQ(second["equations"][0], "nn");
  EXPECT_EQ(second["matrices"]["stiffness"]["pareto_front"], true);
  EXPECT_TRUE(second["matrices"]["stiffness"]["rms_relative_error"]["q95"].is_null());
  EXPECT_EQ(second["statuses"]["ok"], 7);
  EXPECT_EQ(json["left_out"][0]["reason"], "no such block");
}

TEST(ComparisonCsv, HasALinePerCombinationAndMatrix) {
  const std::string csv = report::comparison_csv(sample_comparison());
  EXPECT_EQ(std::ranges::count(csv, '\n'), 3);
  EXPECT_THAT(csv, HasSubstr("one,nn,WBS,0.05,qr,stiffness,0.9876,0.1,1,1.0123,0.5,1.5,0.3,0.3,,0.25,true,0.002,4000,none\n"));
}

TEST(Comparisons, OfALikelihoodHaveNoWeighting) {
  tasks::ComparisonResult report = sample_comparison();
  report.comparison.combinations[1].way = {ident::Method::likelihood, {ident::Equation::nn}, weighting::Weighting::wb, 0.0,
                                               ident::Solver::iqml};
  EXPECT_THAT(report::comparison_text(report), testing::ContainsRegex("likelihood +nn +– +– +iqml"));
  EXPECT_THAT(report::comparison_csv(report), HasSubstr("likelihood,nn,,,iqml,stiffness"));
  const auto json = nlohmann::json::parse(report::comparison_json(report));
  EXPECT_TRUE(json["combinations"][1]["weighting"].is_null());
  EXPECT_TRUE(json["combinations"][1]["delta"].is_null());
  EXPECT_EQ(json["combinations"][0]["weighting"], "WBS");
}

TEST(ReproductionText, CountsWhatIsLegible) {
  const problems::ThesisTable& table = problems::thesis_table("6.8");
  ReproductionReport report{table, 10, 1, std::vector<problems::Reproduced>(table.entries.size())};
  report.results[0].inside = true;
  EXPECT_THAT(reproduction_text(report), HasSubstr("\n1 of 63 entries"));
  EXPECT_THAT(reproduction_text(report), HasSubstr("0.90690?"));
  EXPECT_THAT(table_list(), HasSubstr("\n6.19"));
  const auto json = nlohmann::json::parse(reproduction_json(report));
  EXPECT_EQ(json["entries"].size(), 64u);
  EXPECT_EQ(json["doubtful"], 1);
  EXPECT_EQ(std::ranges::count(reproduction_csv(report), '\n'), 65);
}

}  // namespace
}  // namespace jointid::cli
