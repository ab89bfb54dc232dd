#include "report/result/plan_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "ident/admissible/constraint_phrases.hpp"
#include "ident/equations/system_pattern.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"
#include "ident/likelihood/parts/likelihood_by_parts.hpp"
#include "ident/plan/expected_time.hpp"
#include "ident/plan/models_of_plan.hpp"
#include "report/json_value.hpp"
#include "report/models_json.hpp"
#include "report/result/bound_json.hpp"
#include "report/text/dof_list.hpp"
#include "report/text/models_text.hpp"
#include "report/text/table.hpp"
#include "report/text/variances_text.hpp"
#include "report/text/words.hpp"

namespace jointid::report {
namespace {

std::vector<std::string> equation_names(const ident::Plan& plan) {
  std::vector<std::string> names;
  for (const auto equation : plan.equations) names.push_back(ident::name(equation));
  return names;
}

std::string lines_text(const std::vector<ident::Line>& lines) {
  return fmt::format("{}, {:g} to {:g} Hz", lines.size(), lines.front().frequency_hz, lines.back().frequency_hz);
}

std::string unknowns_text(const ident::Plan& plan) {
  std::vector<std::string> names;
  for (const auto& unknown : plan.restriction.unknowns) names.push_back(unknown.name);
  const std::string columns =
      plan.cost.columns == names.size() ? "" : fmt::format(" in {} columns, one per band", plan.cost.columns);
  constexpr std::size_t most = 200, shown = 12;
  const std::string more = names.size() > most ? fmt::format(" … and {} more", names.size() - shown) : "";
  const std::size_t count = names.size();
  if (count > most) names.resize(shown);
  return fmt::format("{}{}: {}{}", count, columns, fmt::join(names, " "), more);
}

double megabytes(std::size_t bytes) { return static_cast<double>(bytes) / 1e6; }

/// On all cores of this machine.
std::string cost_text(const ident::Plan& plan) {
  const ident::Cost& cost = plan.cost;
  Table table({{"", Align::left}, {""}});
  table.add({"FRFs to read, MB", number(megabytes(cost.bytes_read))});
  table.add({"equations per line", fmt::format("{}", cost.equations_per_line)});
  if (const ident::Iteration& each = cost.iteration; each.expected > 0) {
    table.add({"an iteration, Mflop", number(each.flops / 1e6)});
    table.add({"iterations expected", fmt::format("{}", each.expected)});
    table.add({"memory, MB", number(megabytes(each.memory_bytes))});
    const auto [least, most] = ident::expected_range_s(plan);
    table.add({"time of the iterations expected, s", fmt::format("{:.2g} ({:.2g} to {:.2g})", ident::expected_seconds(cost), least, most)});
  } else {
    table.add({"rows per line after compression", fmt::format("{}", cost.compressed_rows_per_line)});
    table.add({"assembling, Mflop", number(cost.assemble_flops / 1e6)});
    table.add({"one dense QR of all equations, Mflop", number(cost.stacked_flops / 1e6)});
  }
  return "\ncost\n" + table.text();
}

/// From so many unknowns on it matters which of them meet.
constexpr std::size_t least_of_pattern = 150;

std::optional<ident::SystemPattern> pattern_of(const ident::Plan& plan) {
  const auto linear = ident::system_pattern(plan, least_of_pattern);
  return linear ? linear : ident::pattern_by_parts(plan, least_of_pattern);
}

std::string wide_text(const std::vector<std::string>& files) {
  constexpr std::size_t most = 4;
  const std::vector<std::string> first(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(std::min(most, files.size())));
  return fmt::format("{}{}", fmt::join(first, ", "), files.size() > most ? fmt::format(" and {} more", files.size() - most) : "");
}

std::string pattern_text(const ident::Plan& plan) {
  const std::optional<ident::SystemPattern> found = pattern_of(plan);
  if (!found) return "";
  Table table({{"", Align::left}, {""}});
  table.add({"joints", fmt::format("{}", found->joints)});
  table.add({"groups of rows, one or a few substructures where they are kept apart", fmt::format("{}", found->supports)});
  table.add({"unknowns of the widest" + (found->widest_file.empty() ? "" : ", " + found->widest_file), fmt::format("{}", found->widest)});
  if (!found->wide_files.empty()) table.add({"substructures with more than half of the unknowns", wide_text(found->wide_files)});
  table.add({"pairs of joints that share rows", fmt::format("{} of {}", found->joint_pairs, found->joints * found->joints)});
  table.add({"numbers in the factor", fmt::format("{}", found->factor_entries)});
  table.add({"of a dense one", percent(found->share_of_dense())});
  table.add({"memory of the factor, MB", number(megabytes(16 * found->factor_entries))});
  std::string text = "\nstructure\n" + table.text();
  constexpr std::size_t most = 40;
  for (const std::string& line : found->picture(most)) text += "  " + line + "\n";
  return text;
}

Json pattern_json(const ident::SystemPattern& found) {
  return {{"joints", found.joints},
          {"row_groups", found.supports},
          {"widest_unknowns", found.widest},
          {"widest_file", found.widest_file.empty() ? Json(nullptr) : Json(found.widest_file)},
          {"wide_files", found.wide_files},
          {"joint_pairs_coupled", found.joint_pairs},
          {"factor_entries", found.factor_entries},
          {"factor_share_of_dense", found.share_of_dense()},
          {"factor_bytes", 16 * found.factor_entries},
          {"joints_of_row_groups", found.joints_of}};
}

Json variances_json(const std::vector<ident::VarianceSource>& files) {
  Json all = Json::array();
  for (const auto& file : files) all.push_back({{"file", file.file}, {"origin", file.origin}});
  return all;
}

Json cost_json(const ident::Plan& plan) {
  const ident::Cost& cost = plan.cost;
  return {{"equations_per_line", cost.equations_per_line},
          {"compressed_rows_per_line", cost.compressed_rows_per_line},
          {"columns", cost.columns},
          {"bytes_read", cost.bytes_read},
          {"assemble_flops", cost.assemble_flops},
          {"stacked_flops", cost.stacked_flops},
          {"iteration_flops", cost.iteration.flops},
          {"iterations", cost.iteration.expected},
          {"memory_bytes", cost.iteration.memory_bytes},
          {"expected_s", ident::expected_seconds(cost)},
          {"expected_range_s", ident::expected_range_s(plan)}};
}

/// What delta lets pass by (6.62): right-hand sides c1 − c2 whose relative error is up to 2·level/delta.
std::optional<double> error_passed(const ident::Plan& plan) {
  const ident::Scene& scene = plan.scene;
  if (!ident::weighs_equations(scene.identify.method) || !scene.noise || !(scene.noise->level > 0.0)) return std::nullopt;
  if (!(scene.identify.delta > 0.0)) return std::nullopt;
  return 2.0 * scene.noise->level / scene.identify.delta;
}

std::string what_delta_lets_pass(const ident::Plan& plan) {
  const auto passed = error_passed(plan);
  if (!passed) return {};
  return fmt::format("delta = {:g} keeps equations whose right-hand side is wrong by up to {:.3g} % with errors of {:.3g} % (6.62). "
                     "{:.2g} keeps those up to 100 %. 0.05 to 0.3 was best with WBS in Table 6.13",
                     plan.scene.identify.delta, 100.0 * *passed, 100.0 * plan.scene.noise->level, 2.0 * plan.scene.noise->level);
}

}  // namespace

std::string plan_text(const ident::Plan& plan) {
  Table table({{"", Align::left}, {"", Align::left}});
  const auto& identify = plan.scene.identify;
  if (!plan.chosen.empty()) table.add({"chosen", plan.chosen});
  table.add({"method", method_text(identify.method, plan.equations, identify.weighting, identify.delta, name(plan.solver))});
  if (const std::string delta = what_delta_lets_pass(plan); !delta.empty()) table.add({"equations", delta});
  table.add({"joint DOFs", dof_list(plan.coordinates.joint)});
  table.add({"other responses", dof_list(plan.coordinates.responses)});
  table.add({"other references", dof_list(plan.coordinates.references)});
  table.add({"lines", lines_text(plan.lines)});
  table.add({"unknowns", unknowns_text(plan)});
  table.add({"assembly FRFs", !plan.predicted_responses.empty() ? "synthesised and compared" : "not synthesised"});
  return (plan.scene.title.empty() ? "" : plan.scene.title + "\n") + table.text() +
         phrases("constraints", ident::constraint_phrases(plan)) + cost_text(plan) + pattern_text(plan) +
         variances_text(ident::variance_sources(plan)) + planned_models_text(ident::used_models(plan)) +
         phrases("left out", plan.left_out) + phrases("warnings", plan.warnings) + phrases("notes", plan.notes);
}

std::string plan_json(const ident::Plan& plan, const std::optional<tasks::BoundReport>& bound) {
  const auto& identify = plan.scene.identify;
  const bool weighs = ident::weighs_equations(identify.method);
  Json json = {{"title", plan.scene.title},
               {"method", ident::name(identify.method)},
               {"chosen", plan.chosen.empty() ? Json(nullptr) : Json(plan.chosen)},
               {"equations", equation_names(plan)},
               {"weighting", weighs ? Json(weighting::name(identify.weighting)) : Json(nullptr)},
               {"delta", weighs ? Json(identify.delta) : Json(nullptr)},
               {"error_passed_by_delta", value(error_passed(plan))},
               {"solver", name(plan.solver)},
               {"dofs", frf::names(plan.coordinates.joint)},
               {"responses", frf::names(plan.coordinates.responses)},
               {"references", frf::names(plan.coordinates.references)}};
  json["frequency_hz"] = Json::array();
  for (const auto& line : plan.lines) json["frequency_hz"].push_back(line.frequency_hz);
  json["unknowns"] = Json::array();
  for (const auto& unknown : plan.restriction.unknowns) {
    json["unknowns"].push_back({{"name", unknown.name}, {"unit", unknown.unit}});
  }
  json["constraints"] = ident::constraint_phrases(plan);
  json["predicts_assembly"] = !plan.predicted_responses.empty();
  json["cost"] = cost_json(plan);
  if (const auto pattern = pattern_of(plan)) json["structure"] = pattern_json(*pattern);
  json["variances"] = variances_json(ident::variance_sources(plan));
  if (!plan.models.empty()) json["models"] = models_json(ident::used_models(plan), true);
  json["left_out"] = plan.left_out;
  json["warnings"] = plan.warnings;
  json["notes"] = plan.notes;
  if (bound) json["bound"] = bound_json(*bound);
  return json_text(json);
}

}  // namespace jointid::report
