#include "report/text/models_text.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "report/models_json.hpp"
#include "report/result/solution_of_json.hpp"
#include "report/solution_json.hpp"
#include "solution_sample.hpp"

namespace jointid::report {
namespace {

using models::ModelUse, models::ModelWay;
using testing::AllOf, testing::HasSubstr, testing::Not;

/// One of each way.
std::vector<ident::UsedModel> sample_models() {
  ModelUse reduced{.way = ModelWay::reduced, .coordinates = 1575};
  reduced.factorizations = 1;
  reduced.reduced_lines = 73;
  reduced.vectors = 126;
  reduced.shifts = 3;
  reduced.bound = 1e-11;
  reduced.error = 6.6e-12;
  reduced.worst_hz = 2407.5;
  reduced.expected_bytes = 21e6;
  reduced.expected_seconds = 0.25;
  reduced.expected_vectors = 120;
  ModelUse few{.way = ModelWay::factorised, .reason = "fewer than 12 lines", .coordinates = 900};
  few.factorizations = 5;
  ModelUse full{.way = ModelWay::full, .coordinates = 12};
  full.factorizations = 20;
  return {{"a.toml", reduced}, {"b.toml", few}, {"c.toml", full}, {"d.toml", {.way = ModelWay::modes, .coordinates = 6}}};
}

TEST(ModelsText, ThePlanStatesBoundMemoryAndTime) {
  const std::string text = planned_models_text(sample_models());
  EXPECT_THAT(text, HasSubstr("reduced basis, shifts until the estimated error is at most 1e-11 of the largest FRF of a line"));
  EXPECT_THAT(text, HasSubstr("120 vectors, 21 MB, 0.25 s"));
  EXPECT_THAT(text, HasSubstr("each line is factorised: fewer than 12 lines"));
  EXPECT_THAT(text, AllOf(HasSubstr("as a full matrix"), HasSubstr("sum over modes"), Not(HasSubstr("6.6e-12"))));
  EXPECT_EQ(planned_models_text({}), "");
}

TEST(ModelsText, TheResultStatesVectorsShiftsAndError) {
  const std::string text = used_models_text(sample_models());
  EXPECT_THAT(text,
              HasSubstr("reduced basis of 126 vectors, 3 shifts; estimated error 6.6e-12 of the largest FRF of a line (bound "
                        "1e-11), worst at 2407.5 Hz; 73 lines; 1 factorisation\n"));
  EXPECT_THAT(text, HasSubstr("each line is factorised: fewer than 12 lines; 5 factorisations"));
  EXPECT_EQ(used_models_text({}), "");
  std::vector<ident::UsedModel> rounded = sample_models();
  rounded[0].use.error = 7e-11;
  EXPECT_THAT(used_models_text(rounded),
              HasSubstr("7.0e-11 of the largest FRF of a line (bound 1e-11: more vectors make it no less)"));
}

TEST(ModelsText, ManyModelsAreCutOff) {
  const std::vector<ident::UsedModel> models(30, sample_models().front());
  EXPECT_THAT(used_models_text(models), HasSubstr("10 more models: --json"));
  EXPECT_THAT(planned_models_text(models), HasSubstr("10 more models: --json"));
}

TEST(ModelsJson, APlanHasWhatIsExpectedAndAResultWhatWasDone) {
  const Json plan = models_json(sample_models(), true), result = models_json(sample_models(), false);
  ASSERT_EQ(plan.size(), 4U);
  EXPECT_EQ(plan[0], Json::parse(R"({"file": "a.toml", "coordinates": 1575, "way": "reduced", "bound": 1e-11,
    "expected": {"vectors": 120, "memory_bytes": 21e6, "processor_s": 0.25}})"));
  EXPECT_EQ(result[0], Json::parse(R"({"file": "a.toml", "coordinates": 1575, "way": "reduced", "bound": 1e-11,
    "basis": {"vectors": 126, "shifts": 3, "error": 6.6e-12, "worst_hz": 2407.5}, "reduced_lines": 73, "factorizations": 1})"));
  EXPECT_EQ(result[1], Json::parse(R"({"file": "b.toml", "coordinates": 900, "way": "factorised", "reason": "fewer than 12 lines",
    "reduced_lines": 0, "factorizations": 5})"));
  EXPECT_EQ(result[3]["way"], "modes");
}

TEST(ModelsJson, ComesBackWithTheSolution) {
  ident::Solution solution = sample_solution();
  solution.models = sample_models();
  const std::string json = solution_json(solution);
  EXPECT_THAT(json, HasSubstr("\"worst_hz\": 2407.5"));
  EXPECT_EQ(solution_json(solution_of_json(Json::parse(json))), json);
}

}  // namespace
}  // namespace jointid::report
