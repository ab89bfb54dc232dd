#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "report/json_value.hpp"
#include "report/series/delay_report.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::string exponent_text(const oscillation::RecordExponent& found) {
  if (!found.nats_per_second) return "not determined: " + found.reason;
  return fmt::format("{} nats per s (slopes of d, d + 1, d + 2 within ± {:.2g})", number(*found.nats_per_second), found.spread);
}

Json exponent_json(const oscillation::RecordExponent& found) {
  return {{"nats_per_second", value(found.nats_per_second)}, {"spread", value(found.spread)}, {"reason", found.reason}};
}

void add_curve(std::string& text, const std::string& name, const std::vector<double>& x, const std::vector<double>& y) {
  for (std::size_t k = 0; k < y.size(); ++k) text += csv_line({name, csv_number(x[k]), csv_number(y[k])});
}

}  // namespace

Table neighbours_table(const tasks::DelayResult& report) {
  Table table({{"dimension"}, {"points"}, {"false by ratio %"}, {"by size %"}, {"either %"}});
  for (const oscillation::FalseNeighbours& row : report.neighbours) {
    table.add({fmt::format("{}", row.dimension), fmt::format("{}", row.points), fmt::format("{:.2f}", 100.0 * row.ratio),
               fmt::format("{:.2f}", 100.0 * row.size), fmt::format("{:.2f}", 100.0 * row.either)});
  }
  return table;
}

Table answers_table(const tasks::DelayResult& report) {
  Table table({{"", Align::left}, {"", Align::left}});
  const oscillation::Embedding& embedding = report.embedding;
  table.add(
      {"delay", fmt::format("{} samples = {} s{}", embedding.delay, number(static_cast<double>(embedding.delay) / report.rate_hz),
                            report.delay_given ? ", given" : "")});
  table.add({"dimension", fmt::format("{}{}", embedding.dimension, report.dimension_given ? ", given" : "")});
  table.add({"Theiler window", fmt::format("{} samples", report.theiler)});
  const auto& dimension = report.correlation.dimension;
  table.add({"correlation dimension", dimension ? fmt::format("{:.3f} ± {:.3f}", dimension->slope, dimension->spread)
                                                : "not determined: ln C over ln r is nowhere straight"});
  table.add({"largest exponent, Rosenstein", exponent_text(report.rosenstein)});
  table.add({"largest exponent, Kantz", exponent_text(report.kantz)});
  return table;
}

Table wolf_table(const tasks::DelayResult& report) {
  Table table({{"evolution samples"}, {"evolution s"}, {"pairs"}, {"replaced"}, {"bits per s"}, {"nats per s"}});
  for (const tasks::WolfRow& row : report.wolf) {
    table.add({fmt::format("{}", row.evolve), number(static_cast<double>(row.evolve) / report.rate_hz),
               fmt::format("{}", row.found.pairs), fmt::format("{}", row.found.replaced), number(row.found.bits_per_second),
               number(row.found.bits_per_second * std::numbers::ln2)});
  }
  return table;
}

Table recurrences_table(const tasks::DelayResult& report) {
  Table table({{"period samples"}, {"period s"}, {"how often"}, {"closest"}, {"at sample"}});
  for (const oscillation::RecurrentPeriod& each : report.recurrences) {
    table.add({fmt::format("{}", each.best.period), number(static_cast<double>(each.best.period) / report.rate_hz),
               fmt::format("{}", each.count), number(each.best.distance), fmt::format("{}", each.best.start + 1)});
  }
  return table;
}

std::string delay_text(const tasks::DelayResult& report) {
  std::string text =
      fmt::format("{}, channel {}: {} samples at {} Hz\n", report.file, report.channel, report.samples, number(report.rate_hz));
  text += notes_text(report.remarks);
  text += answers_table(report).text();
  text += "\nfalse neighbours (Kennel: ratio above 10, size above 2)\n" + neighbours_table(report).text();
  if (!report.wolf.empty()) {
    text += fmt::format("\nexponent by Wolf, pairs {} to {} apart: a number only where it stays as the evolution grows\n",
                        number(report.wolf_range[0]), number(report.wolf_range[1])) +
            wolf_table(report).text();
  }
  if (!report.recurrences.empty()) text += "\nrecurrences: starts for unstable orbits\n" + recurrences_table(report).text();
  return text;
}

std::string delay_json(const tasks::DelayResult& report) {
  Json out = {{"status", "ok"},
              {"file", report.file},
              {"channel", report.channel},
              {"unit", report.unit},
              {"rate_hz", value(report.rate_hz)},
              {"samples", report.samples},
              {"delay", report.embedding.delay},
              {"dimension", report.embedding.dimension},
              {"theiler", report.theiler},
              {"mutual_information_bits", values(report.information.bits)},
              {"mutual_information_bias_bits", value(report.information_bias)}};
  out["first_minimum"] = report.information.first_minimum ? Json(*report.information.first_minimum) : Json();
  out["false_neighbours"] = Json::array();
  for (const oscillation::FalseNeighbours& row : report.neighbours) {
    out["false_neighbours"].push_back({{"dimension", row.dimension},
                                       {"points", row.points},
                                       {"ratio", value(row.ratio)},
                                       {"size", value(row.size)},
                                       {"either", value(row.either)},
                                       {"squared_ratio", value(row.squared_ratio)}});
  }
  const auto& dimension = report.correlation.dimension;
  out["correlation_dimension"] = dimension ? value(dimension->slope) : Json();
  out["exponent_rosenstein"] = exponent_json(report.rosenstein);
  out["exponent_kantz"] = exponent_json(report.kantz);
  if (!report.wolf.empty()) {
    const std::vector<double> range(report.wolf_range.begin(), report.wolf_range.end());
    out["exponent_wolf"] = {{"range", values(range)}, {"rows", Json::array()}};
    for (const tasks::WolfRow& row : report.wolf) {
      out["exponent_wolf"]["rows"].push_back({{"evolve", row.evolve},
                                              {"pairs", row.found.pairs},
                                              {"replaced", row.found.replaced},
                                              {"bits_per_second", value(row.found.bits_per_second)}});
    }
  }
  out["recurrence_radius"] = value(report.recurrence_radius);
  out["recurrences"] = Json::array();
  for (const oscillation::RecurrentPeriod& each : report.recurrences) {
    out["recurrences"].push_back({{"period", each.best.period},
                                  {"count", each.count},
                                  {"distance", value(each.best.distance)},
                                  {"start", each.best.start}});
  }
  out["remarks"] = report.remarks;
  return json_text(out);
}

std::string delay_csv(const tasks::DelayResult& report) {
  std::string text = csv_line({"curve", "x", "y"});
  std::vector<double> lag;
  for (std::size_t k = 0; k < report.information.bits.size(); ++k) lag.push_back(static_cast<double>(k) / report.rate_hz);
  add_curve(text, "mutual information bits over s", lag, report.information.bits);
  add_curve(text, "correlation sum", report.correlation.radius, report.correlation.sum);
  for (const oscillation::DivergenceCurve& curve : report.rosenstein.curves)
    add_curve(text, fmt::format("Rosenstein d={} ln distance over s", curve.dimension), curve.time, curve.mean_log);
  for (const oscillation::DivergenceCurve& curve : report.kantz.curves)
    add_curve(text, fmt::format("Kantz d={} r={:.4g} ln distance over s", curve.dimension, curve.radius), curve.time,
              curve.mean_log);
  return text;
}

}  // namespace jointid::report
