#include "report/result/kept_run.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "report/json_value.hpp"
#include "report/result/solution_of_json.hpp"
#include "report/solution_json.hpp"

namespace jointid::report {
namespace {

constexpr const char* run_format = "jointid-run";
constexpr int run_version = 1;
/// Errors of the elements of larger joint matrices are not kept.
constexpr std::size_t most_dofs_with_errors = 300;

Json answer_json(const tasks::WorthAnswer& answer) {
  Json out = {{"question", static_cast<int>(answer.question)},
              {"light", static_cast<int>(answer.light)},
              {"text", answer.text},
              {"unknown", answer.unknown}};
  if (const auto& place = answer.element)
    out["element"] = {
        {"band", place->band}, {"matrix", restrictions::key(place->kind)}, {"row", place->row}, {"column", place->column}};
  if (answer.frf) out["frf"] = {answer.frf->response.name(), answer.frf->reference.name()};
  return out;
}

template <class Enum>
Enum enumerator(const Json& json, Enum last) {
  const int number = json.get<int>();
  if (number < 0 || number > static_cast<int>(last))
    refuse(json.dump() + " is not understood", "it may be of a newer version of jointid");
  return static_cast<Enum>(number);
}

tasks::WorthAnswer answer_of(const Json& json) {
  tasks::WorthAnswer out{.question = enumerator(json.at("question"), tasks::WorthQuestion::better_than_none),
                         .light = enumerator(json.at("light"), tasks::Light::unknown),
                         .text = json.at("text").get<std::string>(),
                         .unknown = json.at("unknown").get<std::string>()};
  if (json.contains("element")) {
    const Json& place = json.at("element");
    out.element = tasks::MatrixElement{place.at("band").get<std::size_t>(), matrix_kind(place.at("matrix").get<std::string>()),
                                       place.at("row").get<std::size_t>(), place.at("column").get<std::size_t>()};
  }
  if (json.contains("frf")) {
    out.frf = tasks::FrfEntry{frf::Dof::parse(json.at("frf").at(0).get<std::string>()),
                              frf::Dof::parse(json.at("frf").at(1).get<std::string>())};
  }
  return out;
}

Json iterations_json(const tasks::UnknownsByIteration& found) {
  Json steps = Json::array();
  for (const auto& [iteration, objective, all] : found.iterations) steps.push_back({iteration, value(objective), values(all)});
  return {{"unknowns", found.names}, {"steps", steps}};
}

tasks::UnknownsByIteration iterations_of(const Json& json) {
  tasks::UnknownsByIteration out{json.at("unknowns").get<std::vector<std::string>>(), {}};
  for (const Json& step : json.at("steps")) {
    tasks::IterationUnknowns one{step.at(0).get<std::size_t>(), {}, {}};
    if (!step.at(1).is_null()) one.objective = step.at(1).get<double>();
    for (const Json& each : step.at(2)) one.values.push_back(number_of(each));
    out.iterations.push_back(std::move(one));
  }
  return out;
}

/// Errors of the matrix elements, band by band.
Json errors_json(const ident::Solution& solution) {
  Json out = Json::array();
  if (solution.dofs.size() > most_dofs_with_errors) return out;
  for (const ident::BandMatrices& band : solution.bands) {
    Json by_kind = Json::object();
    for (const auto& [kind, rows] : band.errors) by_kind[restrictions::key(kind)] = values(rows);
    out.push_back(std::move(by_kind));
  }
  return out;
}

void read_errors(const Json& json, ident::Solution& solution) {
  for (std::size_t band = 0; band < json.size() && band < solution.bands.size(); ++band) {
    for (const auto& [key, rows] : json.at(band).items()) {
      ident::Matrix& errors = solution.bands[band].errors[matrix_kind(key)];
      for (const Json& row : rows) {
        errors.emplace_back();
        for (const Json& each : row) errors.back().push_back(number_of(each));
      }
    }
  }
}

[[noreturn]] void refuse_run(const std::string& problem) {
  throw InputError({.kind = ErrorKind::data, .file = "", .place = "", .problem = problem, .remedy = "solve the scene again"});
}

KeptRun run_of(const Json& json) {
  if (!json.is_object() || json.value("format", std::string()) != run_format) refuse_run("it is no kept run of jointid");
  if (json.at("version").get<int>() != run_version)
    refuse_run("version " + json.at("version").dump() + " of kept runs is not known");
  KeptRun out{.made = json.at("made").get<std::string>(),
              .scene = json.at("scene").get<std::string>(),
              .inputs = {},
              .solution = solution_of_json(json.at("solution")),
              .worth = {},
              .iterations = iterations_of(json.at("iterations"))};
  for (const Json& each : json.at("inputs"))
    out.inputs.push_back({each.at(0).get<std::string>(), each.at(1).get<std::uint64_t>(), each.at(2).get<std::int64_t>()});
  for (const Json& each : json.at("worth")) out.worth.push_back(answer_of(each));
  read_errors(json.at("errors"), out.solution);
  return out;
}

}  // namespace

std::string kept_run_json(const KeptRun& run) {
  Json inputs = Json::array(), worth = Json::array();
  for (const auto& [file, bytes, modified] : run.inputs) inputs.push_back({file, bytes, modified});
  for (const tasks::WorthAnswer& answer : run.worth) worth.push_back(answer_json(answer));
  Json out = {{"format", run_format}, {"version", run_version}, {"made", run.made}, {"scene", run.scene}};
  out["inputs"] = inputs;
  out["worth"] = worth;
  out["iterations"] = iterations_json(run.iterations);
  out["errors"] = errors_json(run.solution);
  out["solution"] = Json::parse(solution_json(run.solution));
  return json_text(out);
}

KeptRun read_kept_run(const std::string& text) {
  try {
    return run_of(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    refuse_run(std::string("it is no kept run of jointid: ") + error.what());
  }
}

}  // namespace jointid::report
