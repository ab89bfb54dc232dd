#include "report/laws/law_comparison_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "laws/task/identify_laws.hpp"
#include "report/json_value.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

using laws::ComparedValue;
using laws::LawComparison;

std::string heading(const std::string& way) { return way == "two_steps" ? "two steps" : way; }

/// Trials that the way answers with every number.
std::size_t answered(const LawComparison& comparison, std::size_t way) {
  std::size_t least = comparison.trials;
  for (const ComparedValue& value : comparison.values) least = std::min(least, value.ways[way].answers);
  return comparison.values.empty() ? 0 : least;
}

std::string told(double number) { return std::isfinite(number) ? fmt::format("{:.2g}", number) : "–"; }

}  // namespace

Table law_ways_table(const LawComparison& comparison) {
  std::vector<Column> columns = {{"joint", Align::left}, {"", Align::left}, {"truth"}, {"unit", Align::left}, {"bound"}};
  for (const std::string& way : comparison.ways) {
    columns.push_back({heading(way) + ": rms error"});
    columns.push_back({"bias"});
    columns.push_back({"answers"});
  }
  columns.push_back({"times"});
  Table table(std::move(columns));
  for (const ComparedValue& value : comparison.values) {
    std::vector<std::string> row = {value.joint, value.name, number(value.truth, value.bound), value.unit, told(value.bound)};
    for (const laws::WayError& way : value.ways)
      row.insert(row.end(), {told(way.rms_error), told(way.bias), std::to_string(way.answers)});
    row.push_back(told(value.ways.back().rms_error / value.ways.front().rms_error));
    table.add(std::move(row));
  }
  return table;
}

std::string law_ways_summary(const LawComparison& comparison) {
  std::string text =
      fmt::format("{} trials; laws {}, known to both ways: {}\n", comparison.trials,
                  comparison.assumed ? "assumed" : "found from the measured levels", laws::laws_text(comparison.laws));
  if (comparison.without_response > 0)
    text += fmt::format("no response of the drawn parts in {} trials\n", comparison.without_response);
  for (std::size_t way = 0; way < comparison.ways.size(); ++way) {
    text += fmt::format("{}: answers in {} of {}, {} s a trial\n", heading(comparison.ways[way]), answered(comparison, way),
                        comparison.trials, told(comparison.seconds[way]));
  }
  return text;
}

std::string law_comparison_text(const laws::LawScene& scene, const LawComparison& comparison) {
  std::string text = (scene.title.empty() ? "" : scene.title + "\n") + law_ways_summary(comparison) + "\n";
  text += law_ways_table(comparison).text() + "\n";
  text += notes_text(comparison.notes);
  return text;
}

std::string law_comparison_json(const LawComparison& comparison) {
  Json out = {{"laws", comparison.laws}, {"trials", comparison.trials}, {"without_response", comparison.without_response},
              {"ways", Json::array()},   {"values", Json::array()},     {"notes", comparison.notes}};
  for (std::size_t way = 0; way < comparison.ways.size(); ++way)
    out["ways"].push_back({{"name", comparison.ways[way]}, {"seconds", value(comparison.seconds[way])}});
  for (const ComparedValue& each : comparison.values) {
    Json errors = Json::array();
    for (const laws::WayError& way : each.ways)
      errors.push_back({{"answers", way.answers}, {"bias", value(way.bias)}, {"rms_error", value(way.rms_error)}});
    out["values"].push_back({{"joint", each.joint},
                             {"name", each.name},
                             {"unit", each.unit},
                             {"truth", value(each.truth)},
                             {"bound", value(each.bound)},
                             {"ways", errors}});
  }
  return json_text(out);
}

std::string law_comparison_csv(const LawComparison& comparison) {
  std::string text = csv_line({"joint", "quantity", "unit", "truth", "bound", "way", "bias", "rms error", "answers", "trials"});
  for (const ComparedValue& each : comparison.values) {
    for (std::size_t way = 0; way < each.ways.size(); ++way) {
      text += csv_line({each.joint, each.name, each.unit, csv_number(each.truth), csv_number(each.bound), comparison.ways[way],
                        csv_number(each.ways[way].bias), csv_number(each.ways[way].rms_error),
                        std::to_string(each.ways[way].answers), std::to_string(comparison.trials)});
    }
  }
  return text;
}

std::string law_comparison_page(const laws::LawScene& scene, const LawComparison& comparison) {
  ReportPage page(scene.title.empty() ? "Friction laws from vibration: ways compared" : scene.title, "jointid compare");
  const std::size_t usable = answered(comparison, 0);
  page.status(trials_banner(usable, comparison.trials, "no trial gave usable laws",
                            fmt::format("{} of {} trials gave usable laws.", usable, comparison.trials)));
  page.section("Summary");
  page.add(Text{law_ways_summary(comparison)});
  for (const std::string& note : comparison.notes) page.add(Text{note, true});
  page.section("Errors");
  page.add(law_ways_table(comparison));
  page.add(
      Text{"Two steps: equivalent stiffness and damping of the joint over its amplitude, then the law fitted to that curve "
           "(7.3 and (7.20) of Ren's thesis). Times: how many times larger their rms errors are. Bound: the least deviation "
           "that any unbiased estimate can have.",
           true});
  return page.html();
}

}  // namespace jointid::report
