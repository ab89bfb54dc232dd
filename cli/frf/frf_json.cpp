#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "cli/frf/frf_text.hpp"
#include "report/json_value.hpp"

namespace jointid::cli {
namespace {

report::Json stretch_json(const FrfRun& run, const records::Blow& blow) {
  return {{"file", run.record_files[blow.record]},
          {"from_s", begin_s(run, blow)},
          {"force_n", report::value(blow.force)},
          {"kept", blow.rejected.empty()},
          {"reason", blow.rejected.empty() ? report::Json(nullptr) : report::Json(blow.rejected)}};
}

report::Json frf_entry(const FrfRun& run, std::size_t r, std::size_t c) {
  const Spread of = spread(coherences(run, r, c));
  return {
      {"response", run.made.set.header.response[r].name()},
      {"reference", run.made.set.header.reference[c].name()},
      {"coherence", {{"low", report::value(of.low)}, {"median", report::value(of.median)}, {"high", report::value(of.high)}}}};
}

}  // namespace

std::string frf_json(const FrfRun& run, const FrfArguments& arguments) {
  const frf::FrfHeader& header = run.made.set.header;
  report::Json json = {{"estimator", records::name(run.options.estimator)}, {"quantity", frf::name(header.quantity)}};
  json["lines"] = header.lines();
  json["range_hz"] = {header.frequency_hz.front(), header.frequency_hz.back()};
  json["notes"] = notes(run);
  json["stretches"] = report::Json::array();
  for (const records::Blow& blow : run.made.blows) json["stretches"].push_back(stretch_json(run, blow));
  json["references"] = report::Json::array();
  for (const records::Averages& of : run.made.averages) {
    json["references"].push_back(
        {{"dof", of.reference.name()}, {"kept", of.kept}, {"found", of.found}, {"averages", report::value(of.effective)}});
  }
  json["frfs"] = report::Json::array();
  for (std::size_t c = 0; c < header.reference.size(); ++c) {
    for (std::size_t r = 0; r < header.response.size(); ++r) json["frfs"].push_back(frf_entry(run, r, c));
  }
  json["variances"] = !run.made.set.variance.empty();
  json["covariances"] = run.made.set.has_covariance();
  json["output"] = arguments.output ? report::Json(arguments.output->string()) : report::Json(nullptr);
  return report::json_text(json);
}

}  // namespace jointid::cli
