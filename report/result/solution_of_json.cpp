#include "report/result/solution_of_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "report/models_json.hpp"

namespace jointid::report {

double number_of(const Json& json) { return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>(); }

restrictions::Kind matrix_kind(const std::string& key) {
  for (const restrictions::Kind kind : restrictions::all_kinds) {
    if (restrictions::key(kind) == key) return kind;
  }
  refuse("'" + key + "' is no joint matrix", "it may be of a newer version of jointid");
}

namespace {

std::optional<double> number_if(const Json& json) { return json.is_null() ? std::nullopt : std::optional(json.get<double>()); }

std::vector<double> numbers_of(const Json& json) {
  std::vector<double> out;
  for (const Json& each : json) out.push_back(number_of(each));
  return out;
}

ident::Matrix matrix_of(const Json& json) {
  ident::Matrix out;
  for (const Json& row : json) out.push_back(numbers_of(row));
  return out;
}

std::vector<frf::Dof> dofs_of(const Json& json) {
  std::vector<frf::Dof> out;
  for (const Json& each : json) out.push_back(frf::Dof::parse(each.get<std::string>()));
  return out;
}

/// The enumerator from the first to `last` that has this name.
template <class Enum>
Enum enum_of(const Json& json, Enum last) {
  const auto text = json.get<std::string>();
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    if (name(static_cast<Enum>(i)) == text) return static_cast<Enum>(i);
  }
  refuse("'" + text + "' is not understood", "it may be of a newer version of jointid");
}

ident::Estimate estimate_of(const Json& json) {
  ident::Estimate out{.name = json.at("name").get<std::string>(),
                      .unit = json.at("unit").get<std::string>(),
                      .value = number_of(json.at("value")),
                      .determined = json.at("determined").get<bool>(),
                      .std_error = number_if(json.at("std_error")),
                      .ci95 = {},
                      .rounding = number_if(json.at("rounding"))};
  if (const Json& interval = json.at("ci95"); !interval.is_null())
    out.ci95 = {number_of(interval.at(0)), number_of(interval.at(1))};
  out.error_estimate = number_if(json.at("error_estimate"));
  out.bias = number_if(json.at("bias"));
  if (json.contains("limit") && !json.at("limit").is_null()) out.limit = json.at("limit").get<std::string>();
  return out;
}

ident::Matrices matrices_of(const Json& json) {
  ident::Matrices out;
  for (const auto& [key, rows] : json.items()) out[matrix_kind(key)] = matrix_of(rows);
  return out;
}

/// Whole matrices of what is stated in blocks.
ident::Matrices joined_blocks(const Json& blocks, const std::vector<frf::Dof>& dofs) {
  ident::Matrices out;
  for (const Json& block : blocks) {
    std::vector<std::size_t> places;
    for (const frf::Dof& dof : dofs_of(block.at("dofs"))) places.push_back(frf::find_coordinate(dofs, dof));
    for (const auto& [kind, part] : matrices_of(block.at("matrices"))) {
      const auto has_size = [&](const std::vector<double>& row) { return row.size() == places.size(); };
      if (part.size() != places.size() || !std::ranges::all_of(part, has_size) ||
          std::ranges::find(places, frf::npos) != places.end())
        refuse("a block of a matrix has another size than its DOFs", "write it anew: jointid solve SCENE --json FILE");
      ident::Matrix& whole = out[kind];
      if (whole.empty()) whole.assign(dofs.size(), std::vector<double>(dofs.size(), 0.0));
      for (std::size_t i = 0; i < places.size(); ++i) {
        for (std::size_t j = 0; j < places.size(); ++j) whole[places[i]][places[j]] = part[i][j];
      }
    }
  }
  return out;
}

ident::BandMatrices band_of(const Json& json, const std::vector<frf::Dof>& dofs) {
  ident::BandMatrices out;
  if (json.contains("band_hz") && !json.at("band_hz").is_null()) {
    out.band_hz = ident::Range{json.at("band_hz").at(0).get<double>(), json.at("band_hz").at(1).get<double>()};
  }
  out.matrices = json.contains("blocks") ? joined_blocks(json.at("blocks"), dofs) : matrices_of(json.at("matrices"));
  return out;
}

std::vector<ident::BandMatrices> bands_of(const Json& json, const std::vector<frf::Dof>& dofs) {
  std::vector<ident::BandMatrices> out;
  if (json.contains("bands")) {
    for (const Json& band : json.at("bands")) out.push_back(band_of(band, dofs));
  } else if (json.contains("blocks") || !json.at("matrices").is_null()) {
    out.push_back(band_of(json, dofs));
  }
  return out;
}

ident::Fit fit_of(const Json& json) {
  ident::Fit out;
  out.equations_used = json.at("equations_used").get<std::size_t>();
  out.equations_dropped = json.at("equations_dropped").get<std::size_t>();
  out.lines = json.at("lines").get<std::size_t>();
  out.rank = json.at("rank").get<std::size_t>();
  out.condition = number_of(json.at("condition"));
  out.digits = number_if(json.at("digits"));
  out.iterations = json.at("iterations").get<std::size_t>();
  out.asm_frf_error = number_if(json.at("asm_frf_error"));
  out.misfit = number_if(json.at("misfit"));
  if (const Json& found = json.at("chi_square"); !found.is_null()) {
    out.chi_square = {.value = number_of(found.at("value")),
                      .degrees_of_freedom = number_of(found.at("degrees_of_freedom")),
                      .outlying_lines = found.at("outlying_lines").get<std::size_t>(),
                      .by_line = numbers_of(found.at("by_line"))};
  }
  return out;
}

ident::MinimumSearch search_of(const Json& json) {
  ident::MinimumSearch out;
  out.equally_good = json.at("equally_good").get<std::size_t>();
  for (const Json& each : json.at("minima"))
    out.minima.push_back({number_of(each.at("cost")), each.at("starts").get<std::size_t>(), numbers_of(each.at("values"))});
  return out;
}

ident::Admissibility admissibility_of(const Json& json) {
  ident::Admissibility out{.chi_square = number_of(json.at("chi_square")),
                           .equations = json.at("equations").get<std::size_t>(),
                           .from_variances = json.at("scale") == "variances",
                           .constraints = {}};
  for (const Json& each : json.at("constraints")) {
    out.constraints.push_back({each.at("constraint").get<std::string>(), each.at("size").get<std::size_t>(),
                               each.at("at_limit").get<std::size_t>(), number_of(each.at("chi_square"))});
  }
  return out;
}

ident::LinearCombination combination_of(const Json& json) {
  return {json.at("unknowns").get<std::vector<std::string>>(), numbers_of(json.at("factors")), number_of(json.at("deviation"))};
}

ident::Identifiability identifiability_of(const Json& json) {
  ident::Identifiability out;
  for (const Json& each : json.at("weakest")) {
    ident::WeakCombination weak{combination_of(each.at("worst")), {}, number_if(each.at("correlation"))};
    if (!each.at("best").is_null()) weak.best = combination_of(each.at("best"));
    out.weakest.push_back(std::move(weak));
  }
  out.joint = {number_if(json.at("joint").at("effect")), number_if(json.at("joint").at("deformation"))};
  out.largest_relative_error = number_of(json.at("largest_relative_error"));
  for (const Json& each : json.value("calibration", Json::array())) {
    ident::CalibrationShare share{each.at("unknown").get<std::string>(), number_of(each.at("share")), {}};
    for (const auto& [key, part] : each.at("largest").items()) share.largest.emplace_back(key, number_of(part));
    out.calibration.push_back(std::move(share));
  }
  for (const Json& each : json.at("findings"))
    out.findings.push_back({enum_of(each.at("kind"), ident::FindingKind::gain), each.at("text").get<std::string>()});
  return out;
}

virtualpoint::SideConsistency side_of(const Json& json) {
  virtualpoint::SideConsistency out;
  if (json.is_null()) return out;
  for (const auto& [dof, specific] : json.at("specific").items()) {
    out.dofs.push_back(frf::Dof::parse(dof));
    out.specific.push_back(number_of(specific));
  }
  out.overall = numbers_of(json.at("overall"));
  return out;
}

ident::ReciprocityMap reciprocity_of(const Json& json) {
  ident::ReciprocityMap out{.file = json.at("file").get<std::string>(), .dofs = {}, .overall = number_of(json.at("rms"))};
  if (json.contains("dofs")) out.dofs = dofs_of(json.at("dofs"));
  if (json.contains("map")) out.rms = matrix_of(json.at("map"));
  return out;
}

ident::CheckResult check_of(const Json& json) {
  ident::CheckResult out{.verdict = enum_of(json.at("verdict"), ident::Verdict::wrong), .suspects = {}};
  for (const Json& each : json.at("suspects")) {
    const Json& remedy = each.at("remedy");
    out.suspects.push_back({enum_of(each.at("kind"), ident::SuspectKind::force_noise), each.at("file").get<std::string>(),
                            dofs_of(each.at("dofs")), each.at("evidence").get<std::string>(), number_of(each.at("confidence")),
                            remedy.is_null() ? std::string() : remedy.get<std::string>()});
  }
  for (const Json& note : json.value("notes", Json::array())) out.notes.push_back(note.get<std::string>());
  for (const Json& map : json.value("reciprocity", Json::array())) out.reciprocity.push_back(reciprocity_of(map));
  for (const Json& each : json.value("virtual_points", Json::array())) {
    virtualpoint::Consistency point;
    point.file = each.at("file").get<std::string>();
    point.point = each.at("virtual_point").get<std::string>();
    point.frequency_hz = numbers_of(each.at("frequency_hz"));
    point.sensors = side_of(each.at("sensors"));
    point.impacts = side_of(each.at("impacts"));
    point.rigidity = numbers_of(each.at("rigidity"));
    out.virtual_points.push_back(std::move(point));
  }
  return out;
}

ident::Used used_of(const Json& json) {
  ident::Used out;
  out.method = ident::parse_method(json.at("method").get<std::string>());
  for (const Json& each : json.at("equations")) out.equations.push_back(ident::parse_equation(each.get<std::string>()));
  if (!json.at("weighting").is_null()) out.weighting = weighting::parse_weighting(json.at("weighting").get<std::string>());
  if (!json.at("delta").is_null()) out.delta = json.at("delta").get<double>();
  out.solver = json.at("solver").get<std::string>();
  out.chosen = json.value("chosen", std::string());
  return out;
}

/// The parts that few solutions have.
void read_findings(const Json& json, ident::Solution& out) {
  if (json.contains("search")) out.search = search_of(json.at("search"));
  if (json.contains("admissibility")) out.admissibility = admissibility_of(json.at("admissibility"));
  if (json.contains("identifiability")) {
    out.identifiability = identifiability_of(json.at("identifiability"));
    out.intervals = enum_of(json.at("identifiability").at("intervals"), ident::IntervalKind::sandwich);
  }
  if (json.contains("check")) out.check = check_of(json.at("check"));
  for (const Json& each : json.value("loose", Json::array())) {
    out.loose.push_back({each.at("joint").get<std::string>(), number_of(each.at("lost")), number_if(each.at("std_error")),
                         each.at("probability").get<double>(), number_if(each.at("loss_factor"))});
  }
  for (const Json& each : json.value("parts", Json::array())) {
    out.parts.push_back(
        {each.at("files").get<std::string>(), number_of(each.at("chi_square")), number_of(each.at("degrees_of_freedom"))});
  }
  for (const Json& each : json.value("systematic", Json::array())) {
    out.systematic.push_back({each.at("name").get<std::string>(), each.at("unit").get<std::string>(), number_of(each.at("value")),
                              number_if(each.at("std_error")), number_of(each.at("prior").at(0)),
                              number_of(each.at("prior").at(1))});
  }
  for (const Json& each : json.at("variances")) {
    out.variances.push_back(
        {each.at("file").get<std::string>(), each.at("origin").get<std::string>(), each.at("note").get<std::string>()});
  }
  out.models = models_of_json(json.value("models", Json::array()));
}

ident::Solution read_solution(const Json& json) {
  ident::Solution out;
  out.status = enum_of(json.at("status"), ident::Status::too_few_points);
  out.message = json.at("message").get<std::string>();
  for (const Json& each : json.at("unknowns")) out.unknowns.push_back(estimate_of(each));
  out.dofs = dofs_of(json.at("dofs"));
  out.bands = bands_of(json, out.dofs);
  out.fit = fit_of(json.at("fit"));
  for (const auto& [key, figures] : json.at("quality").items()) {
    out.quality[matrix_kind(key)] = {number_of(figures.at("rjcf")), number_of(figures.at("arvf")),
                                     number_of(figures.at("rms_relative_error"))};
  }
  for (const auto& [phase, seconds] : ident::run_time_phases) out.runtime_s.*seconds = json.at("runtime_s").value(phase, 0.0);
  out.runtime_s.total = json.at("runtime_s").at("total").get<double>();
  out.used = used_of(json.at("used"));
  out.warnings = json.at("warnings").get<std::vector<std::string>>();
  read_findings(json, out);
  return out;
}

}  // namespace

ident::Solution solution_of_json(const Json& json) {
  try {
    return read_solution(json);
  } catch (const nlohmann::json::exception& error) {
    throw InputError({.kind = ErrorKind::data,
                      .file = "",
                      .place = "solution",
                      .problem = std::string("it is no solution of jointid: ") + error.what(),
                      .remedy = "write it anew: jointid solve SCENE --json FILE"});
  }
}

}  // namespace jointid::report
