#include <nlohmann/json.hpp>

#include "base/statistics.hpp"
#include "report/frf/frf_text.hpp"
#include "report/json_value.hpp"

namespace jointid::report {
namespace {

Json stretch_json(const tasks::FrfRun& run, const records::Blow& blow) {
  return {{"file", run.record_files[blow.record]},
          {"from_s", tasks::begin_s(run, blow)},
          {"force_n", value(blow.force)},
          {"kept", blow.rejected.empty()},
          {"reason", blow.rejected.empty() ? Json(nullptr) : Json(blow.rejected)}};
}

Json frf_entry(const tasks::FrfRun& run, std::size_t r, std::size_t c) {
  const Spread of = spread(tasks::coherences(run, r, c));
  return {{"response", run.made.set.header.response[r].name()},
          {"reference", run.made.set.header.reference[c].name()},
          {"coherence", {{"low", value(of.low)}, {"median", value(of.median)}, {"high", value(of.high)}}}};
}

}  // namespace

std::string frf_json(const tasks::FrfRun& run, const std::optional<std::filesystem::path>& output) {
  const frf::FrfHeader& header = run.made.set.header;
  Json json = {{"estimator", records::name(run.options.estimator)}, {"quantity", frf::name(header.quantity)}};
  json["lines"] = header.lines();
  json["range_hz"] = {header.frequency_hz.front(), header.frequency_hz.back()};
  json["notes"] = notes(run);
  json["stretches"] = Json::array();
  for (const records::Blow& blow : run.made.blows) json["stretches"].push_back(stretch_json(run, blow));
  json["references"] = Json::array();
  for (const records::Averages& of : run.made.averages) {
    json["references"].push_back(
        {{"dof", of.reference.name()}, {"kept", of.kept}, {"found", of.found}, {"averages", value(of.effective)}});
  }
  json["frfs"] = Json::array();
  for (std::size_t c = 0; c < header.reference.size(); ++c) {
    for (std::size_t r = 0; r < header.response.size(); ++r) json["frfs"].push_back(frf_entry(run, r, c));
  }
  json["variances"] = !run.made.set.variance.empty();
  json["covariances"] = run.made.set.has_covariance();
  json["output"] = output ? Json(output->string()) : Json(nullptr);
  return json_text(json);
}

}  // namespace jointid::report
