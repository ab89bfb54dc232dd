#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/modalfit/modalfit_text.hpp"
#include "modalfit/model/mac.hpp"
#include "report/json_value.hpp"
#include "report/modalfit/modal_run.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

report::Json error(const modalfit::SynthesisError& of) {
  return {{"rms_db", report::value(of.rms_db)}, {"rms_db_away", report::value(of.rms_db_away)}};
}

report::Json mode(const report::ModalRun& run, const report::Shapes& all, std::size_t r) {
  const modalfit::Mode& of = run.fit.modes[r];
  report::Json json = {{"frequency_hz", of.pole.frequency_hz},
                       {"frequency_std", report::value(of.frequency_deviation_hz)},
                       {"damping", of.pole.damping},
                       {"damping_std", report::value(of.damping_deviation)},
                       {"significance", report::value(of.significance)},
                       {"scatter", report::value(of.scatter)},
                       {"own_hz", {report::value(of.own_hz[0]), report::value(of.own_hz[1])}},
                       {"inside", of.inside}};
  json["rank_one_misfit"] = run.symmetric ? report::value(run.symmetric->modes[r].misfit) : report::Json(nullptr);
  json["shape"] = report::Json::array();
  for (const auto& component : all.of_mode[r]) json["shape"].push_back({component.real(), component.imag()});
  return json;
}

report::Json frfs(const report::ModalRun& run) {
  report::Json list = report::Json::array();
  const std::size_t columns = run.fit.reference.size();
  for (std::size_t e = 0; e < run.of_fit.size(); ++e) {
    if (run.of_fit[e].lines == 0) continue;
    report::Json json = {{"response", run.fit.response[e / columns].name()},
                         {"reference", run.fit.reference[e % columns].name()},
                         {"fit", error(run.of_fit[e])}};
    json["symmetric"] = run.symmetric ? error(run.of_model[e]) : report::Json(nullptr);
    list.push_back(std::move(json));
  }
  return list;
}

report::Json stabilisation(const report::ModalRun& run) {
  report::Json list = report::Json::array();
  for (const auto& order : run.fit.stabilisation) {
    for (const auto& pole : order.poles) {
      list.push_back({{"order", order.order},
                      {"frequency_hz", pole.frequency_hz},
                      {"zeta", pole.damping},
                      {"frequency_std", report::value(pole.deviation_hz)}});
    }
  }
  return list;
}

}  // namespace

std::string modalfit_json(const report::ModalRun& run) {
  const report::Shapes all = shapes(run);
  report::Json json = {{"status", modalfit::name(run.fit.status)}, {"message", run.fit.message}, {"notes", notes(run)}};
  json["model"] = {{"damping", modalfit::name(run.fit.kind.damping)}, {"real_modes", run.fit.kind.real_modes}};
  json["range_hz"] = {run.band.frequency_hz.front(), run.band.frequency_hz.back()};
  json["dofs"] = frf::names(all.dofs);
  json["modes"] = report::Json::array();
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) json["modes"].push_back(mode(run, all, r));
  json["mac"] = report::Json::array();
  for (const auto& one : all.of_mode) {
    report::Json row = report::Json::array();
    for (const auto& other : all.of_mode) row.push_back(report::value(modalfit::mac(one, other)));
    json["mac"].push_back(std::move(row));
  }
  json["fit"] = {{"lines", run.band.lines()},
                 {"known_noise", run.fit.known_noise},
                 {"cost", report::value(run.fit.cost)},
                 {"degrees_of_freedom", run.fit.freedom},
                 {"refined_frfs", run.fit.refined_entries},
                 {"iterations", run.fit.iterations},
                 {"synthesis", error(modalfit::overall(run.of_fit))}};
  json["fit"]["synthesis_symmetric"] = run.symmetric ? error(modalfit::overall(run.of_model)) : report::Json(nullptr);
  json["frfs"] = frfs(run);
  json["stabilisation"] = stabilisation(run);
  json["runtime_s"] = {{"read", run.read_s}, {"fit", run.fit_s}};
  return report::json_text(json);
}

std::string modes_csv(const report::ModalRun& run) {
  std::string csv =
      report::csv_line({"mode", "frequency_hz", "frequency_std", "damping", "damping_std", "significance", "inside"});
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) {
    const modalfit::Mode& mode = run.fit.modes[r];
    csv += report::csv_line({fmt::format("{}", r + 1), report::csv_number(mode.pole.frequency_hz),
                             report::csv_number(mode.frequency_deviation_hz), report::csv_number(mode.pole.damping),
                             report::csv_number(mode.damping_deviation), report::csv_number(mode.significance),
                             mode.inside ? "true" : "false"});
  }
  return csv;
}

}  // namespace jointid::cli
