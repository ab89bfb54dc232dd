#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "cli/options/output.hpp"
#include "cli/series/measured_records.hpp"
#include "cli/series/series_command.hpp"
#include "frf/file/columns.hpp"
#include "report/json_value.hpp"
#include "report/text/table.hpp"
#include "series/measurement/phase.hpp"

namespace jointid::cli {
namespace {

/// A channel, its fundamental and how late it is.
struct Late {
  std::string name;
  double amplitude = 0.0, delay = 0.0;  ///< delay in s
};

/// The place of a channel by name, whatever its case, or number from 1.
std::size_t place_of(const records::SeriesRecord& record, const std::string& wanted) {
  frf::Columns titles{record.file, {}};
  for (const auto& [name, unit] : record.channels) titles.columns.push_back({name, unit, {}});
  return static_cast<std::size_t>(&titles.column(wanted) - titles.columns.data());
}

std::vector<Late> delays_of(const SeriesAlignArguments& arguments, const records::SeriesRecord& record) {
  const double step = 1.0 / record.rate_hz;
  const std::vector<double>& reference = record.samples[place_of(record, arguments.reference)];
  std::vector<Late> out;
  for (std::size_t k = 0; k < record.samples.size(); ++k) {
    const auto& x = record.samples[k];
    out.push_back({record.channels[k].name,
                   series::fit_harmonics(x, step, arguments.frequency_hz, arguments.harmonics).amplitude.front(),
                   series::sensor_delay(reference, x, step, arguments.frequency_hz, arguments.harmonics)});
  }
  return out;
}

std::string delays_text(const std::vector<Late>& found, const SeriesAlignArguments& arguments) {
  report::Table table({{"channel", report::Align::left}, {"amplitude"}, {"late by s"}, {"degrees"}});
  for (const Late& each : found) {
    table.add({each.name, report::number(each.amplitude), report::number(each.delay),
               fmt::format("{:.3f}", 360.0 * arguments.frequency_hz * each.delay)});
  }
  return fmt::format(
             "against {} at {} Hz; a delay is known up to whole periods, and holds the phase that the motion itself has between "
             "the places\n",
             arguments.reference, report::number(arguments.frequency_hz)) +
         table.text();
}

std::string delays_json(const std::vector<Late>& found, const SeriesAlignArguments& arguments) {
  report::Json out = {{"status", "ok"},
                      {"reference", arguments.reference},
                      {"frequency_hz", report::value(arguments.frequency_hz)},
                      {"channels", report::Json::array()}};
  for (const Late& each : found) {
    out["channels"].push_back({{"name", each.name},
                               {"amplitude", report::value(each.amplitude)},
                               {"delay_s", report::value(each.delay)},
                               {"degrees", report::value(360.0 * arguments.frequency_hz * each.delay)}});
  }
  return report::json_text(out);
}

}  // namespace

ExitCode execute(const SeriesAlignArguments& arguments, std::ostream& out) {
  check_series_targets(arguments.file, {{"--output", arguments.output}, {"--json", arguments.json}});
  records::SeriesRecord record = records::read_series(arguments.file, {{}, arguments.rate_hz, 0});
  const std::vector<Late> found = delays_of(arguments, record);
  if (arguments.output) {
    for (std::size_t k = 0; k < found.size(); ++k) {
      if (found[k].delay != 0.0) record.samples[k] = series::advanced(record.samples[k], 1.0 / record.rate_hz, found[k].delay);
    }
    write_target(*arguments.output, record_csv(record), out);
  }
  if (arguments.json) write_target(*arguments.json, delays_json(found, arguments), out);
  if (!takes_output({arguments.output, arguments.json})) out << delays_text(found, arguments);
  return ExitCode::done;
}

}  // namespace jointid::cli
