#include <nlohmann/json.hpp>

#include "cli/study/study_text.hpp"
#include "report/json_value.hpp"

namespace jointid::cli {
namespace {

report::Json unknown(const study::UnknownStatistics& of) {
  return {{"name", of.name},
          {"unit", of.unit},
          {"truth", report::value(of.truth)},
          {"mean", report::value(of.mean)},
          {"bias", report::value(of.bias)},
          {"std", report::value(of.std_deviation)},
          {"rms_error", report::value(of.rms_error)},
          {"quantiles", report::values(of.quantiles)},
          {"coverage", report::value(of.coverage)}};
}

}  // namespace

std::string study_json(const StudyReport& report) {
  const study::StudyStatistics& of = report.statistics;
  report::Json json = {{"trials",
                        {{"all", of.trials},
                         {"ok", of.usable - of.doubtful},
                         {"rank_deficient", of.rank_deficient},
                         {"no_equations", of.no_equations},
                         {"not_converged", of.not_converged},
                         {"doubtful", of.doubtful},
                         {"poor_fit", of.poor_fit}}},
                       {"seed", report.seed},
                       {"file", report.file},
                       {"notes", report.notes},
                       {"quantile_levels", study::study_quantiles}};
  json["unknowns"] = report::Json::array();
  for (const auto& one : of.unknowns) json["unknowns"].push_back(unknown(one));
  json["quality"] = report::Json::object();
  for (const auto& matrix : of.quality) {
    json["quality"][matrix.matrix] = {{"rjcf", report::values(matrix.rjcf)},
                                      {"arvf", report::values(matrix.arvf)},
                                      {"rms_relative_error", report::values(matrix.rms_relative_error)},
                                      {"rms_over_trials", report::value(matrix.rms_over_trials)}};
  }
  json["runtime_s"] = {{"total", report.run.wall_s}, {"trials", report.run.computed}, {"one_solution", report.run.solve_s}};
  return report::json_text(json);
}

}  // namespace jointid::cli
