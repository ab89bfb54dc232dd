#include "report/solution_json.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "report/check_json.hpp"
#include "report/identifiability_json.hpp"
#include "report/json_value.hpp"
#include "report/models_json.hpp"
#include "report/text/joints_text.hpp"

namespace jointid::report {
namespace {

Json unknown(const ident::Estimate& estimate, bool constrained) {
  Json json = {{"name", estimate.name},
          {"value", value(estimate.value)},
          {"unit", estimate.unit},
          {"std_error", value(estimate.std_error)},
          {"ci95", value(estimate.ci95)},
          {"rounding", value(estimate.rounding)},
          {"error_estimate", value(estimate.error_estimate)},
          {"bias", value(estimate.bias)},
          {"determined", estimate.determined}};
  if (constrained) json["limit"] = estimate.limit.empty() ? Json(nullptr) : Json(estimate.limit);
  return json;
}

Json admissibility(const ident::Admissibility& found) {
  Json json = {{"chi_square", value(found.chi_square)},
               {"scale", found.from_variances ? "variances" : "residuals"},
               {"equations", found.equations},
               {"constraints", Json::array()}};
  for (const auto& [text, size, at_limit, chi_square] : found.constraints) {
    json["constraints"].push_back({{"constraint", text}, {"size", size}, {"at_limit", at_limit}, {"chi_square", value(chi_square)}});
  }
  return json;
}

/// Joint by joint, where there are many unknowns.
Json joints(const std::vector<JointSummary>& all) {
  Json out = Json::array();
  for (const JointSummary& each : all) {
    Json largest = Json::object();
    for (const auto& [kind, size] : each.by_kind) largest[kind] = {{"value", value(size.largest)}, {"unit", size.unit}};
    const bool has_error = each.worst_error >= 0.0;
    out.push_back({{"joint", each.name},
                   {"unknowns", each.unknowns},
                   {"undetermined", each.undetermined},
                   {"largest", largest},
                   {"worst_unknown", has_error ? Json(each.worst) : Json(nullptr)},
                   {"worst_relative_error", has_error ? value(each.worst_error) : Json(nullptr)}});
  }
  return out;
}

/// Of each joint the pair of DOFs that is seen least, in the order of the joints.
Json relative_motions(const std::vector<ident::RelativeMotion>& pairs) {
  Json all = Json::array();
  std::map<std::string, std::size_t> places;
  for (const ident::RelativeMotion& pair : pairs) {
    const auto [at, is_new] = places.try_emplace(pair.joint, all.size());
    Json one = {{"joint", pair.joint}, {"dofs", {pair.a.name(), pair.b.name()}}, {"over_error", value(pair.over_error)}};
    if (is_new) {
      all.push_back(std::move(one));
    } else if (pair.over_error < all[at->second]["over_error"].get<double>()) {
      all[at->second] = std::move(one);
    }
  }
  return all;
}

Json loose_joints(const std::vector<ident::LooseJoint>& joints) {
  Json all = Json::array();
  for (const auto& [joint, lost, std_error, probability, loss_factor] : joints) {
    all.push_back({{"joint", joint},
                   {"lost", value(lost)},
                   {"std_error", value(std_error)},
                   {"probability", probability},
                   {"loss_factor", value(loss_factor)}});
  }
  return all;
}

/// χ² of some substructures alone.
Json part_misfits(const std::vector<ident::PartMisfit>& parts) {
  Json all = Json::array();
  for (const auto& [files, chi_square, freedom] : parts)
    all.push_back({{"files", files}, {"chi_square", value(chi_square)}, {"degrees_of_freedom", freedom}});
  return all;
}

Json matrices(const ident::Matrices& by_kind) {
  Json all = Json::object();
  for (const auto& [kind, rows] : by_kind) all[restrictions::key(kind)] = values(rows);
  return all;
}

/// From more joint DOFs on the matrices are stated in blocks: whole ones of many joints are nearly all zeros.
constexpr std::size_t most_of_whole = 300;

/// Joint DOFs that some matrix joins, directly or through others: those of a joint, or of joints with common DOFs.
std::vector<std::vector<std::size_t>> joined_dofs(const ident::Matrices& by_kind, std::size_t dofs) {
  std::vector<bool> seen(dofs, false);
  std::vector<std::vector<std::size_t>> blocks;
  for (std::size_t first = 0; first < dofs; ++first) {
    if (seen[first]) continue;
    std::vector<std::size_t> block = {first};
    seen[first] = true;
    for (std::size_t i = 0; i < block.size(); ++i) {
      for (const auto& [kind, rows] : by_kind) {
        for (std::size_t other = first + 1; other < dofs; ++other) {
          if (seen[other] || (rows[block[i]][other] == 0.0 && rows[other][block[i]] == 0.0)) continue;
          seen[other] = true;
          block.push_back(other);
        }
      }
    }
    std::ranges::sort(block);
    blocks.push_back(std::move(block));
  }
  return blocks;
}

Json blocks(const ident::Matrices& by_kind, const std::vector<frf::Dof>& dofs) {
  Json all = Json::array();
  for (const std::vector<std::size_t>& block : joined_dofs(by_kind, dofs.size())) {
    Json names = Json::array(), own = Json::object();
    for (const std::size_t dof : block) names.push_back(dofs[dof].name());
    for (const auto& [kind, rows] : by_kind) {
      ident::Matrix part;
      for (const std::size_t i : block) {
        part.emplace_back();
        for (const std::size_t j : block) part.back().push_back(rows[i][j]);
      }
      own[restrictions::key(kind)] = values(part);
    }
    all.push_back({{"dofs", names}, {"matrices", own}});
  }
  return all;
}

Json bands(const std::vector<ident::BandMatrices>& list, const std::vector<frf::Dof>& dofs) {
  Json all = Json::array();
  for (const auto& band : list) {
    Json& to = all.emplace_back(Json{{"band_hz", value(band.band_hz)}});
    if (dofs.size() > most_of_whole) {
      to["blocks"] = blocks(band.matrices, dofs);
    } else {
      to["matrices"] = matrices(band.matrices);
    }
  }
  return all;
}

Json chi_square(const std::optional<ident::ChiSquare>& found) {
  if (!found) return nullptr;
  return {{"value", value(found->value)},
          {"degrees_of_freedom", found->degrees_of_freedom},
          {"outlying_lines", found->outlying_lines},
          {"by_line", values(found->by_line)}};
}

Json systematic(const std::vector<ident::SystematicEstimate>& estimates) {
  Json all = Json::array();
  for (const auto& each : estimates) {
    all.push_back({{"name", each.name},
                   {"value", value(each.value)},
                   {"unit", each.unit},
                   {"std_error", value(each.std_error)},
                   {"prior", {each.prior, each.prior_deviation}}});
  }
  return all;
}

Json variances(const std::vector<ident::VarianceSource>& files) {
  Json all = Json::array();
  for (const auto& [file, origin, note] : files) all.push_back({{"file", file}, {"origin", origin}, {"note", note}});
  return all;
}

Json fit(const ident::Fit& fit) {
  return {{"equations_used", fit.equations_used},
          {"equations_dropped", fit.equations_dropped},
          {"lines", fit.lines},
          {"rank", fit.rank},
          {"condition", value(fit.condition)},
          {"digits", value(fit.digits)},
          {"asm_frf_error", value(fit.asm_frf_error)},
          {"iterations", fit.iterations},
          {"chi_square", chi_square(fit.chi_square)},
          {"misfit", value(fit.misfit)}};
}

/// Where the starts ended, best first.
Json minima(const ident::MinimumSearch& search) {
  Json all = Json::array();
  for (const auto& [cost, starts, unknowns] : search.minima) {
    all.push_back({{"cost", value(cost)}, {"starts", starts}, {"values", values(unknowns)}});
  }
  return {{"equally_good", search.equally_good}, {"minima", all}};
}

Json quality(const std::map<restrictions::Kind, ident::Quality>& by_kind) {
  Json all = Json::object();
  for (const auto& [kind, figures] : by_kind) {
    all[restrictions::key(kind)] = {{"rjcf", value(figures.rjcf)},
                                    {"arvf", value(figures.arvf)},
                                    {"rms_relative_error", value(figures.rms_relative_error)}};
  }
  return all;
}

Json used(const ident::Used& used) {
  const bool weighs = ident::weighs_equations(used.method);
  Json equations = Json::array();
  for (const auto equation : used.equations) equations.push_back(ident::name(equation));
  Json json = {{"method", ident::name(used.method)},
               {"equations", equations},
               {"weighting", weighs ? Json(weighting::name(used.weighting)) : Json(nullptr)},
               {"delta", weighs ? value(used.delta) : Json(nullptr)},
               {"solver", used.solver}};
  if (!used.chosen.empty()) json["chosen"] = used.chosen;
  return json;
}

}  // namespace

std::string solution_json(const ident::Solution& solution) {
  const bool several = solution.bands.size() > 1;
  Json json = {{"status", ident::name(solution.status)}, {"message", solution.message}};
  json["unknowns"] = Json::array();
  for (const auto& estimate : solution.unknowns) json["unknowns"].push_back(unknown(estimate, solution.admissibility.has_value()));
  if (is_shown_by_joint(solution)) json["joints"] = joints(joint_summaries(solution));
  const bool whole = solution.dofs.size() <= most_of_whole;
  json["matrices"] = whole && solution.bands.size() == 1 ? matrices(solution.bands.front().matrices) : Json(nullptr);
  if (!whole && solution.bands.size() == 1) json["blocks"] = blocks(solution.bands.front().matrices, solution.dofs);
  if (several) json["bands"] = bands(solution.bands, solution.dofs);
  json["dofs"] = frf::names(solution.dofs);
  json["fit"] = fit(solution.fit);
  if (solution.search) json["search"] = minima(*solution.search);
  if (solution.admissibility) json["admissibility"] = admissibility(*solution.admissibility);
  if (!solution.relative_motions.empty()) json["relative_motions"] = relative_motions(solution.relative_motions);
  if (!solution.loose.empty()) json["loose"] = loose_joints(solution.loose);
  if (!solution.parts.empty()) json["parts"] = part_misfits(solution.parts);
  if (!solution.systematic.empty()) json["systematic"] = systematic(solution.systematic);
  if (solution.identifiability) json["identifiability"] = identifiability_json(solution);
  json["quality"] = quality(solution.quality);
  const auto& time = solution.runtime_s;
  json["runtime_s"] = {{"read", time.read}, {"assemble", time.assemble}, {"solve", time.solve}, {"total", time.total}};
  for (const auto& [phase, seconds] : ident::run_time_phases) {
    if (time.*seconds > 0.0) json["runtime_s"][phase] = time.*seconds;
  }
  json["used"] = used(solution.used);
  json["variances"] = variances(solution.variances);
  if (!solution.models.empty()) json["models"] = models_json(solution.models, false);
  json["warnings"] = solution.warnings;
  if (solution.check) json["check"] = check_json(*solution.check);
  return json_text(json);
}

}  // namespace jointid::report
