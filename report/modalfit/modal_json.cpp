#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "modalfit/model/mac.hpp"
#include "report/json_value.hpp"
#include "report/modalfit/modal_text.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

Json error(const modalfit::SynthesisError& of) { return {{"rms_db", value(of.rms_db)}, {"rms_db_away", value(of.rms_db_away)}}; }

Json mode(const tasks::ModalRun& run, const tasks::Shapes& all, std::size_t r) {
  const modalfit::Mode& of = run.fit.modes[r];
  Json json = {{"frequency_hz", of.pole.frequency_hz},
               {"frequency_std", value(of.frequency_deviation_hz)},
               {"damping", of.pole.damping},
               {"damping_std", value(of.damping_deviation)},
               {"significance", value(of.significance)},
               {"scatter", value(of.scatter)},
               {"own_hz", {value(of.own_hz[0]), value(of.own_hz[1])}},
               {"inside", of.inside}};
  json["rank_one_misfit"] = run.symmetric ? value(run.symmetric->modes[r].misfit) : Json(nullptr);
  json["shape"] = Json::array();
  for (const auto& component : all.of_mode[r]) json["shape"].push_back({component.real(), component.imag()});
  return json;
}

Json frfs(const tasks::ModalRun& run) {
  Json list = Json::array();
  const std::size_t columns = run.fit.reference.size();
  for (std::size_t e = 0; e < run.of_fit.size(); ++e) {
    if (run.of_fit[e].lines == 0) continue;
    Json json = {{"response", run.fit.response[e / columns].name()},
                 {"reference", run.fit.reference[e % columns].name()},
                 {"fit", error(run.of_fit[e])}};
    json["symmetric"] = run.symmetric ? error(run.of_model[e]) : Json(nullptr);
    list.push_back(std::move(json));
  }
  return list;
}

Json stabilisation(const tasks::ModalRun& run) {
  Json list = Json::array();
  for (const auto& order : run.fit.stabilisation) {
    for (const auto& pole : order.poles) {
      list.push_back({{"order", order.order},
                      {"frequency_hz", pole.frequency_hz},
                      {"zeta", pole.damping},
                      {"frequency_std", value(pole.deviation_hz)}});
    }
  }
  return list;
}

}  // namespace

std::string modal_json(const tasks::ModalRun& run) {
  const tasks::Shapes all = tasks::shapes(run);
  Json json = {{"status", name(run.fit.status)}, {"message", run.fit.message}, {"notes", notes(run)}};
  json["model"] = {{"damping", modalfit::name(run.fit.kind.damping)}, {"real_modes", run.fit.kind.real_modes}};
  json["range_hz"] = {run.band.frequency_hz.front(), run.band.frequency_hz.back()};
  json["dofs"] = frf::names(all.dofs);
  json["modes"] = Json::array();
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) json["modes"].push_back(mode(run, all, r));
  json["mac"] = Json::array();
  for (const auto& one : all.of_mode) {
    Json row = Json::array();
    for (const auto& other : all.of_mode) row.push_back(value(modalfit::mac(one, other)));
    json["mac"].push_back(std::move(row));
  }
  json["fit"] = {{"lines", run.band.lines()},
                 {"known_noise", run.fit.known_noise},
                 {"cost", value(run.fit.cost)},
                 {"degrees_of_freedom", run.fit.freedom},
                 {"refined_frfs", run.fit.refined_entries},
                 {"iterations", run.fit.iterations},
                 {"synthesis", error(modalfit::overall(run.of_fit))}};
  json["fit"]["synthesis_symmetric"] = run.symmetric ? error(modalfit::overall(run.of_model)) : Json(nullptr);
  json["frfs"] = frfs(run);
  json["stabilisation"] = stabilisation(run);
  json["runtime_s"] = {{"read", run.read_s}, {"fit", run.fit_s}};
  return json_text(json);
}

std::string modes_csv(const tasks::ModalRun& run) {
  std::string csv = csv_line({"mode", "frequency_hz", "frequency_std", "damping", "damping_std", "significance", "inside"});
  for (std::size_t r = 0; r < run.fit.modes.size(); ++r) {
    const modalfit::Mode& mode = run.fit.modes[r];
    csv += csv_line({fmt::format("{}", r + 1), csv_number(mode.pole.frequency_hz), csv_number(mode.frequency_deviation_hz),
                     csv_number(mode.pole.damping), csv_number(mode.damping_deviation), csv_number(mode.significance),
                     mode.inside ? "true" : "false"});
  }
  return csv;
}

}  // namespace jointid::report
