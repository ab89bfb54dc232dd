#include "report/couple/couple_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "base/text.hpp"
#include "report/text/models_text.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::string frequencies_text(const std::vector<double>& frequencies_hz) {
  constexpr std::size_t most = 8;
  std::string text =
      comma_list(std::span(frequencies_hz).first(std::min(most, frequencies_hz.size())), [](double hz) { return number(hz); });
  if (frequencies_hz.size() > most) text += fmt::format(", … {} in all", frequencies_hz.size());
  return text.empty() ? "none found" : text + " Hz";
}

std::string kept_text(const ident::CoupleScene& scene, const tasks::CoupleResult& result) {
  const std::string rule = kept_rule(scene);
  if (rule.empty()) return {};
  std::string text;
  for (const auto& [kept, lines] : kept_counts(result)) {
    text += fmt::format("{}{} on {} line{}", text.empty() ? "" : ", ", kept, lines, lines == 1 ? "" : "s");
  }
  return fmt::format("  kept        {}; of {}: {}\n", rule, result.result.conditions, text);
}

}  // namespace

Table conditions_table(const coupling::Dependencies& dependencies) {
  Table table({{"condition", Align::left}, {"alpha"}, {"5 %"}, {"95 %"}, {"", Align::left}});
  for (const coupling::Dependency& condition : dependencies.conditions) {
    table.add({condition.condition, number(condition.median), number(condition.lower), number(condition.upper),
               condition.dependent ? "left out" : ""});
  }
  return table;
}

std::string kept_rule(const ident::CoupleScene& scene) {
  using coupling::Threshold;
  switch (scene.options.threshold) {
    case Threshold::fixed:
      return "singular values above " + number(scene.options.epsilon) + " of the largest";
    case Threshold::noise:
      return "singular values above 3 standard deviations of the noise";
    case Threshold::picard:
      return "singular values before the forces grow (Picard)";
    case Threshold::alpha:
      return "conditions with alpha above " + number(scene.options.alpha);
    case Threshold::none:
      break;
  }
  return {};
}

std::string coupling_method_text(const ident::CoupleScene& scene) {
  std::string text = coupling::name(scene.options.method);
  if (scene.find_dependent) return text + ", threshold auto";
  if (scene.options.threshold == coupling::Threshold::none) return text;
  return text + ", threshold " + coupling::name(scene.options.threshold);
}

std::vector<std::pair<std::size_t, std::size_t>> kept_counts(const tasks::CoupleResult& result) {
  std::map<std::size_t, std::size_t> counts;
  for (const coupling::LineRecord& line : result.records) {
    if (line.usable) ++counts[line.kept];
  }
  std::vector<std::pair<std::size_t, std::size_t>> out(counts.begin(), counts.end());
  std::ranges::stable_sort(out, std::ranges::greater(), &std::pair<std::size_t, std::size_t>::second);
  return out;
}

std::size_t worst_line(const tasks::CoupleResult& result) {
  std::size_t worst = frf::npos;
  for (std::size_t line = 0; line < result.records.size(); ++line) {
    if (std::isnan(result.records[line].condition)) continue;
    if (worst == frf::npos || result.records[line].condition > result.records[worst].condition) worst = line;
  }
  return worst;
}

std::string couple_text(const ident::CoupleScene& scene, const tasks::CoupleResult& result) {
  std::string text = scene.title.empty() ? "" : scene.title + "\n";
  text += fmt::format("coupled by {}: {} conditions, {} lines, {} × {} FRFs\n", coupling_method_text(scene), result.result.conditions,
                      result.lines, result.responses, result.references);
  if (result.lines_without_partner > 0) text += fmt::format("  {} lines are not in all parts\n", result.lines_without_partner);
  for (const std::string& note : result.notes) text += "  " + note + "\n";
  if (!result.message.empty()) text += "  " + result.message + "\n";
  text += kept_text(scene, result);
  if (const std::size_t worst = worst_line(result); worst != frf::npos) {
    text += fmt::format("  condition   at most {} at {} Hz\n", number(result.records[worst].condition), number(result.frequency_hz[worst]));
  }
  if (result.dependencies) {
    text += "dependency of the conditions, median over the lines\n" + conditions_table(*result.dependencies).text() + "  " +
            result.dependencies->reason + "\n";
  }
  if (!result.models.empty()) text += used_models_text(result.models).substr(1);
  const bool is_file = !result.result.path.empty();
  text += "resonances\n  " + (is_file ? result.result.path.string() + ": " : "") + frequencies_text(result.result.resonances_hz) + "\n";
  if (result.with_all) {
    text += "  " + result.with_all->path.string() + ", with all conditions: " + frequencies_text(result.with_all->resonances_hz) + "\n";
  }
  if (is_file) text += "wrote " + result.result.path.string() + (result.with_all ? " and " + result.with_all->path.string() : "") + "\n";
  return text;
}

std::string couple_csv(const tasks::CoupleResult& result) {
  using coupling::LineRecord;
  constexpr std::array<std::pair<const char*, std::vector<double> LineRecord::*>, 3> lists = {
      {{"alpha", &LineRecord::alpha}, {"sigma", &LineRecord::sigma}, {"limit", &LineRecord::limit}}};
  std::vector<std::string> head = {"frequency_hz", "condition", "kept", "usable"};
  for (const auto& [name, list] : lists) {
    const std::size_t count = result.records.empty() ? 0 : (result.records.front().*list).size();
    for (std::size_t p = 0; p < count; ++p) head.push_back(fmt::format("{}_{}", name, p + 1));
  }
  std::string text = csv_line(head);
  for (std::size_t line = 0; line < result.records.size(); ++line) {
    const LineRecord& record = result.records[line];
    std::vector<std::string> row = {fmt::format("{}", result.frequency_hz[line]), fmt::format("{}", record.condition),
                                    fmt::format("{}", record.kept), record.usable ? "1" : "0"};
    for (const auto& [name, list] : lists) {
      for (const double value : record.*list) row.push_back(fmt::format("{}", value));
    }
    text += csv_line(row);
  }
  return text;
}

}  // namespace jointid::report
