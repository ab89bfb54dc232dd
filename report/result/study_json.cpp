#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/result/study_text.hpp"
#include "tasks/study/run_study.hpp"

namespace jointid::report {
namespace {

Json unknown(const study::UnknownStatistics& of) {
  return {{"name", of.name},
          {"unit", of.unit},
          {"truth", value(of.truth)},
          {"mean", value(of.mean)},
          {"bias", value(of.bias)},
          {"std", value(of.std_deviation)},
          {"rms_error", value(of.rms_error)},
          {"quantiles", values(of.quantiles)},
          {"coverage", value(of.coverage)}};
}

}  // namespace

std::string study_json(const tasks::StudyResult& result) {
  const study::StudyStatistics& of = result.statistics;
  Json json = {{"trials",
                {{"all", of.trials},
                 {"ok", of.usable - of.doubtful},
                 {"rank_deficient", of.rank_deficient},
                 {"no_equations", of.no_equations},
                 {"not_converged", of.not_converged},
                 {"doubtful", of.doubtful},
                 {"poor_fit", of.poor_fit}}},
               {"seed", result.seed},
               {"file", result.file},
               {"notes", result.notes},
               {"message", tasks::study_doubt(of)},
               {"quantile_levels", study::study_quantiles}};
  json["unknowns"] = Json::array();
  for (const auto& one : of.unknowns) json["unknowns"].push_back(unknown(one));
  json["quality"] = Json::object();
  for (const auto& matrix : of.quality) {
    json["quality"][matrix.matrix] = {{"rjcf", values(matrix.rjcf)},
                                      {"arvf", values(matrix.arvf)},
                                      {"rms_relative_error", values(matrix.rms_relative_error)},
                                      {"rms_over_trials", value(matrix.rms_over_trials)}};
  }
  json["runtime_s"] = {{"total", result.run.wall_s}, {"trials", result.run.computed}, {"one_solution", result.run.solve_s}};
  return json_text(json);
}

}  // namespace jointid::report
