#include "report/couple/couple_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/couple/couple_plots.hpp"
#include "report/couple/couple_text.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_resonances = 30;

std::string uncertainty_text(const ident::CoupleScene& scene) {
  if (!scene.options.uncertainty) return "not asked for (uncertainty = true)";
  return scene.options.noise ? "to first order, from the files' variances, else from [noise]"
                             : "to first order, from the files' variances";
}

std::string condition_text(const tasks::CoupleResult& result) {
  const std::size_t worst = worst_line(result);
  if (worst == frf::npos) return "–";
  return fmt::format("at most {} at {} Hz", number(result.records[worst].condition), number(result.frequency_hz[worst]));
}

void add_summary(const ident::CoupleScene& scene, const tasks::CoupleResult& result, ReportPage& page) {
  page.section("Summary");
  Facts facts{{{"method", coupling_method_text(scene)},
               {"conditions", result.dependencies
                                  ? fmt::format("{} of {}", result.result.conditions, result.dependencies->conditions.size())
                                  : fmt::format("{}", result.result.conditions)},
               {"FRFs", fmt::format("{} × {}, {} lines", result.responses, result.references, result.lines)},
               {"lines not usable", fmt::format("{}", result.unusable_lines)},
               {"lines not in all parts", fmt::format("{}", result.lines_without_partner)},
               {"condition of S", condition_text(result)},
               {"uncertainty", uncertainty_text(scene)},
               {"result", result.result.path.string()}}};
  if (result.with_all) facts.rows.emplace_back("with all conditions", result.with_all->path.string());
  page.add(facts);
}

StatusBanner couple_banner(const tasks::CoupleResult& result) {
  StatusBanner banner = status_banner(ident::name(result.status), result.message);
  if (banner.trust == Trust::good && result.unusable_lines > 0) {
    banner.trust = Trust::doubtful;
    banner.remarks.push_back(fmt::format("{} of {} lines are not usable.", result.unusable_lines, result.lines));
  }
  return banner;
}

std::vector<std::string> names(const coupling::Dependencies& dependencies) {
  std::vector<std::string> out;
  for (const coupling::Dependency& condition : dependencies.conditions) out.push_back(condition.condition);
  return out;
}

/// Which conditions are met, and why the others are not.
void add_conditions(const ident::CoupleScene& scene, const tasks::CoupleResult& result, ReportPage& page) {
  page.section("Conditions");
  if (result.dependencies) {
    page.add(conditions_table(*result.dependencies), "Alpha of each condition, median over the lines and quantiles");
    page.add(Text{result.dependencies->reason});
    const auto level = result.dependencies->threshold > 0.0 ? std::optional(result.dependencies->threshold) : std::nullopt;
    page.add(alpha_plots(result.frequency_hz, result.survey, names(*result.dependencies), level, most_points));
    page.add(
        Text{"Alpha is about 1 for coordinates that move on their own and 0 for those that the conditions before nearly hold; "
             "the line is "
             "where the medians are parted.",
             true});
  } else {
    Table table({{"condition", Align::left}});
    for (const std::string& condition : result.conditions) table.add({condition});
    page.add(table);
    const bool by_alpha = scene.options.threshold == coupling::Threshold::alpha;
    page.add(alpha_plots(result.frequency_hz, result.records, result.conditions,
                         by_alpha ? std::optional(scene.options.alpha) : std::nullopt, most_points));
  }
}

void add_lines(const ident::CoupleScene& scene, const tasks::CoupleResult& result, ReportPage& page) {
  page.section("Line by line");
  if (const std::string rule = kept_rule(scene); !rule.empty()) {
    page.add(Text{"Kept on each line: " + rule + "."});
    Table table({{"kept"}, {"lines"}});
    for (const auto& [kept, lines] : kept_counts(result))
      table.add({fmt::format("{} of {}", kept, result.result.conditions), fmt::format("{}", lines)});
    page.add(table);
  }
  page.add(condition_plots(result, most_points));
}

void add_frfs(const tasks::CoupleResult& result, const std::vector<tasks::PredictedFrf>& predicted, const Display& display,
              ReportPage& page) {
  page.section("Predicted FRFs");
  page.add(predicted_plots(result.frequency_hz, predicted, most_points, display));
  const std::size_t frfs = result.responses * result.references;
  if (frfs > predicted.size())
    page.add(
        Text{fmt::format("First {} of {} FRFs; {} has all of them.", predicted.size(), frfs, result.result.path.string()), true});
  Table table({{"resonance (Hz)"}});
  if (result.with_all) table = Table({{"resonance (Hz)"}, {"with all conditions (Hz)"}});
  const std::vector<double> all = result.with_all ? result.with_all->resonances_hz : std::vector<double>();
  const std::size_t rows = std::max(result.result.resonances_hz.size(), all.size());
  for (std::size_t i = 0; i < rows; ++i) {
    const auto cell = [i](const std::vector<double>& list) { return i < list.size() ? number(list[i]) : std::string(); };
    std::vector<std::string> row = {cell(result.result.resonances_hz)};
    if (result.with_all) row.push_back(cell(all));
    table.add(row);
  }
  page.add(table, "Resonances", {most_resonances, "--json writes all of them"});
  if (result.with_all) page.add(Text{"A condition that is dependent only in part is right somewhere between the two.", true});
}

}  // namespace

std::string couple_page(const ident::CoupleScene& scene, const tasks::CoupleResult& result,
                        const std::vector<tasks::PredictedFrf>& predicted, const Display& display) {
  const std::string file = scene.file.filename().string();
  ReportPage page(scene.title.empty() ? file : scene.title, "jointid couple " + file);
  page.status(couple_banner(result));
  add_summary(scene, result, page);
  add_conditions(scene, result, page);
  if (!result.records.empty()) {
    add_lines(scene, result, page);
    add_frfs(result, predicted, display, page);
  }
  return page.html();
}

}  // namespace jointid::report
