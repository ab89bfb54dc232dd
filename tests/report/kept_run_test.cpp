#include "report/result/kept_run.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "ident/identify.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "report/result/solution_of_json.hpp"
#include "report/solution_json.hpp"
#include "solution_sample.hpp"

namespace jointid::report {
namespace {

using testing::HasSubstr;

std::string twice(const ident::Solution& solution) {
  return solution_json(solution_of_json(nlohmann::ordered_json::parse(solution_json(solution))));
}

TEST(SolutionOfJson, SamplesComeBack) {
  for (const ident::Solution& solution : {sample_solution(), sample_likelihood(), sample_constrained(), sample_of_many_joints()})
    EXPECT_EQ(twice(solution), solution_json(solution));
}

TEST(SolutionOfJson, SeveralBandsAndLargeMatricesComeBack) {
  ident::Solution solution = sample_solution();
  solution.bands.push_back(solution.bands.front());
  solution.bands[0].band_hz = ident::Range{10.0, 20.0};
  solution.bands[1].band_hz = ident::Range{20.0, 30.0};
  EXPECT_EQ(twice(solution), solution_json(solution));
  solution = sample_solution();
  solution.dofs.clear();
  for (int node = 1; node <= 301; ++node) solution.dofs.push_back(frf::Dof::parse(std::to_string(node) + ":+Y"));
  ident::Matrix rows(301, std::vector<double>(301, 0.0));
  rows[3][300] = rows[300][3] = 7.0;
  solution.bands.front().matrices = {{restrictions::Kind::stiffness, rows}};
  EXPECT_EQ(twice(solution), solution_json(solution));
  EXPECT_EQ(solution_of_json(nlohmann::ordered_json::parse(solution_json(solution))).bands.front().matrices,
            solution.bands.front().matrices);
}

/// With intervals, identifiability, the check of the data and the quality.
TEST(SolutionOfJson, SolutionsOfProblemsComeBack) {
  for (const ident::Method method : {ident::Method::one, ident::Method::likelihood}) {
    const problems::Problem problem = problems::make("A1");
    ident::Scene scene = problems::scene(problem);
    scene.identify.method = method;
    const auto plan = problems::plan(scene, problems::polluted(problem, 1, 0));
    ident::Control control;
    control.judgement = ident::Judgement::data;
    const ident::Solution solution = ident::solve(*plan, control);
    EXPECT_EQ(twice(solution), solution_json(solution));
  }
}

KeptRun sample_run() {
  KeptRun run{.made = "2026-11-30T17:31:02",
              .scene = "[data]\n# \"ä\"\n",
              .inputs = {{"a.uff", 12, -3}},
              .solution = sample_likelihood(),
              .worth = {{.question = tasks::WorthQuestion::passive,
                         .light = tasks::Light::bad,
                         .text = "no",
                         .element = tasks::MatrixElement{0, restrictions::Kind::mass, 1, 0}},
                        {.text = "", .frf = tasks::FrfEntry{frf::Dof::parse("4:+Y"), frf::Dof::parse("5:-RZ")}}},
              .iterations = {{"K(1,1)", "k2"}, {{1, 3.5, {1.0, 2.0}}, {4, {}, {1.5, 2.5}}}}};
  run.solution.bands.front().errors = {{restrictions::Kind::stiffness, {{1.0, 2.0}, {3.0, 4.0}}}};
  return run;
}

TEST(KeptRun, ComesBackWithAllThatWasKept) {
  const KeptRun run = sample_run(), back = read_kept_run(kept_run_json(run));
  EXPECT_EQ(kept_run_json(back), kept_run_json(run));
  EXPECT_EQ(back.scene, run.scene);
  EXPECT_EQ(back.inputs, run.inputs);
  EXPECT_EQ(back.solution.bands.front().errors, run.solution.bands.front().errors);
  ASSERT_EQ(back.worth.size(), 2U);
  EXPECT_EQ(back.worth[0].element->kind, restrictions::Kind::mass);
  EXPECT_EQ(back.worth[1].frf, run.worth[1].frf);
  EXPECT_EQ(back.iterations.iterations[0].objective, 3.5);
  EXPECT_EQ(back.iterations.iterations[1].values, (std::vector<double>{1.5, 2.5}));
}

TEST(KeptRun, AnythingElseIsAnErrorThatNamesIt) {
  const std::string text = kept_run_json(sample_run());
  const auto problem_of = [](const std::string& wrong) -> std::string {
    try {
      read_kept_run(wrong);
    } catch (const InputError& error) {
      return error.what();
    }
    return "read";
  };
  EXPECT_THAT(problem_of("{"), HasSubstr("no kept run"));
  EXPECT_THAT(problem_of("[]"), HasSubstr("no kept run"));
  EXPECT_THAT(problem_of(R"({"format": "jointid-run", "version": 2})"), HasSubstr("version 2"));
  EXPECT_THAT(problem_of(text.substr(0, text.size() / 2)), HasSubstr("no kept run"));
  std::string of_another = text;
  of_another.replace(of_another.find("\"status\""), 8, "\"stasis\"");
  EXPECT_THAT(problem_of(of_another), HasSubstr("no solution of jointid"));
}

}  // namespace
}  // namespace jointid::report
