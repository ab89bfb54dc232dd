#include "report/solution_json.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "solution_sample.hpp"

namespace jointid::report {
namespace {

using Json = nlohmann::ordered_json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> names;
  for (const auto& [key, value] : object.items()) names.push_back(key);
  return names;
}

TEST(SolutionJson, TheKeysStay) {
  const Json json = Json::parse(solution_json(sample_solution()));
  EXPECT_THAT(keys(json), ElementsAre("status", "message", "unknowns", "matrices", "dofs", "fit", "quality",
                                      "runtime_s", "used", "variances", "warnings"));
  EXPECT_THAT(keys(json["unknowns"][0]), ElementsAre("name", "value", "unit", "std_error", "ci95", "rounding", "error_estimate", "bias",
                                                  "determined"));
  EXPECT_THAT(keys(json["fit"]), ElementsAre("equations_used", "equations_dropped", "lines", "rank", "condition", "digits",
                                             "asm_frf_error", "iterations", "chi_square", "misfit"));
  EXPECT_THAT(keys(json["quality"]["stiffness"]), ElementsAre("rjcf", "arvf", "rms_relative_error"));
  EXPECT_THAT(keys(json["runtime_s"]), ElementsAre("read", "assemble", "solve", "total"));
}

TEST(SolutionJson, NumbersKeepAllDigits) {
  auto solution = sample_solution();
  solution.unknowns[0].value = 1.0 / 3.0;
  const Json json = Json::parse(solution_json(solution));
  EXPECT_EQ(json["unknowns"][0]["value"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["matrices"]["stiffness"][1][0].get<double>(), 5.0);
  EXPECT_EQ(json["unknowns"][0]["ci95"].get<std::vector<double>>(), (std::vector<double>{9.9e5, 1.01e6}));
  EXPECT_EQ(json["dofs"].get<std::vector<std::string>>(), (std::vector<std::string>{"4:+Y", "4:+RZ"}));
}

TEST(SolutionJson, WhatIsNotComputedOrNotFiniteIsNull) {
  const Json json = Json::parse(solution_json(sample_solution()));
  EXPECT_TRUE(json["unknowns"][1]["value"].is_null());
  EXPECT_TRUE(json["unknowns"][1]["std_error"].is_null());
  EXPECT_TRUE(json["unknowns"][1]["ci95"].is_null());
  EXPECT_TRUE(json["fit"]["condition"].is_null());
  EXPECT_TRUE(json["fit"]["asm_frf_error"].is_null());
}

TEST(SolutionJson, ManyJointsAreListedOneByOne) {
  EXPECT_FALSE(Json::parse(solution_json(sample_solution())).contains("joints"));
  const Json json = Json::parse(solution_json(sample_of_many_joints()));
  ASSERT_EQ(json["joints"].size(), 500U);
  const Json& worst = json["joints"][76];
  EXPECT_THAT(keys(worst), ElementsAre("joint", "unknowns", "undetermined", "largest", "worst_unknown", "worst_relative_error"));
  EXPECT_EQ(worst["worst_unknown"], "j77.K(1,4)");
  EXPECT_EQ(worst["worst_relative_error"].get<double>(), 0.5);
  EXPECT_EQ(worst["largest"]["D"]["unit"], "N/m");
  EXPECT_EQ(json["joints"][4]["undetermined"], 2);
}

TEST(SolutionJson, OfEachJointThePairThatIsSeenLeastIsListed) {
  EXPECT_FALSE(Json::parse(solution_json(sample_solution())).contains("relative_motions"));
  auto solution = sample_solution();
  const auto dof = [](const char* name) { return frf::Dof::parse(name); };
  solution.relative_motions = {{"j2", dof("3:+Y"), dof("4:+Y"), 12.0}, {"j1", dof("1:+Y"), dof("2:+Y"), 40.0}, {"j2", dof("3:+RZ"), dof("4:+RZ"), 2.5}};
  const Json json = Json::parse(solution_json(solution))["relative_motions"];
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0], Json({{"joint", "j2"}, {"dofs", {"3:+RZ", "4:+RZ"}}, {"over_error", 2.5}}));
  EXPECT_EQ(json[1], Json({{"joint", "j1"}, {"dofs", {"1:+Y", "2:+Y"}}, {"over_error", 40.0}}));
}

TEST(SolutionJson, SeveralBandsAreListed) {
  auto solution = sample_solution();
  solution.bands.push_back(solution.bands.front());
  solution.bands[1].band_hz = {{100.0, 200.0}};
  const Json json = Json::parse(solution_json(solution));
  EXPECT_TRUE(json["matrices"].is_null());
  ASSERT_EQ(json["bands"].size(), 2U);
  EXPECT_TRUE(json["bands"][0]["band_hz"].is_null());
  EXPECT_EQ(json["bands"][1]["band_hz"][1].get<double>(), 200.0);
  EXPECT_EQ(json["bands"][1]["matrices"]["stiffness"][0][0].get<double>(), 1e6);
}

TEST(SolutionJson, OfALikelihoodHasChiSquareAndVariancesButNoWeighting) {
  const Json linear = Json::parse(solution_json(sample_solution()));
  EXPECT_TRUE(linear["fit"]["chi_square"].is_null());
  EXPECT_EQ(linear["used"]["weighting"], "WBS");
  const Json json = Json::parse(solution_json(sample_likelihood()));
  EXPECT_THAT(keys(json["fit"]["chi_square"]), ElementsAre("value", "degrees_of_freedom", "outlying_lines", "by_line"));
  EXPECT_TRUE(json["fit"]["chi_square"]["by_line"][1].is_null());
  EXPECT_EQ(json["fit"]["iterations"], 9);
  EXPECT_TRUE(json["used"]["weighting"].is_null());
  EXPECT_TRUE(json["used"]["delta"].is_null());
  EXPECT_EQ(json["variances"][0]["origin"], "the law of [noise]");
}

TEST(SolutionJson, ConstraintsSayWhatHoldsAndWhatItCosts) {
  const Json json = Json::parse(solution_json(sample_constrained()));
  EXPECT_EQ(json["unknowns"][0]["limit"], "K is singular");
  EXPECT_TRUE(json["unknowns"][1]["limit"].is_null());
  EXPECT_EQ(json["admissibility"]["chi_square"], 12.5);
  EXPECT_EQ(json["admissibility"]["scale"], "variances");
  EXPECT_EQ(json["admissibility"]["constraints"][0]["at_limit"], 1);
  EXPECT_FALSE(Json::parse(solution_json(sample_solution())).contains("admissibility"));
}

/// 151 joints of two DOFs: no 302 × 302 matrix.
TEST(SolutionJson, ManyJointsAreStatedInBlocks) {
  auto solution = sample_solution();
  const std::size_t joints = 151;
  solution.dofs.clear();
  ident::Matrix stiffness(2 * joints, std::vector<double>(2 * joints, 0.0));
  for (std::size_t e = 0; e < joints; ++e) {  // DOFs of a joint lie apart
    for (const std::size_t i : {e, joints + e}) {
      for (const std::size_t j : {e, joints + e}) stiffness[i][j] = (i == j ? 1.0 : -1.0) * static_cast<double>(e + 1);
    }
  }
  for (std::size_t i = 0; i < 2 * joints; ++i) solution.dofs.push_back(frf::Dof::parse(std::to_string(i + 1) + ":+Y"));
  solution.bands.front().matrices = {{restrictions::Kind::stiffness, stiffness}};
  solution.parts = {{"a.h5", 12.0, 10.0}};
  const Json json = Json::parse(solution_json(solution));
  EXPECT_TRUE(json["matrices"].is_null());
  ASSERT_EQ(json["blocks"].size(), joints);
  EXPECT_EQ(json["blocks"][2]["dofs"].get<std::vector<std::string>>(), (std::vector<std::string>{"3:+Y", "154:+Y"}));
  EXPECT_EQ(json["blocks"][2]["matrices"]["stiffness"].get<ident::Matrix>(), (ident::Matrix{{3.0, -3.0}, {-3.0, 3.0}}));
  EXPECT_EQ(json["parts"][0]["files"], "a.h5");
  EXPECT_EQ(json["parts"][0]["degrees_of_freedom"], 10.0);
}

TEST(SolutionJson, NamesThatAreNotUtf8DoNotBreakIt) {
  auto solution = sample_solution();
  solution.message = "caf\xe9";
  EXPECT_THAT(Json::parse(solution_json(solution)).at("message").get<std::string>(), HasSubstr("caf"));
}

}  // namespace
}  // namespace jointid::report
