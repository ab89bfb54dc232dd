#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/statistics.hpp"
#include "cli/options/output.hpp"
#include "cli/series/measured_records.hpp"
#include "cli/series/series_command.hpp"
#include "report/json_value.hpp"
#include "report/laws/law_text.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/table.hpp"
#include "series/measurement/friction_record.hpp"
#include "series/measurement/phase.hpp"

namespace jointid::cli {
namespace {

/// Samples of the contact: those that are there in all channels.
struct ContactSamples {
  std::string file;
  std::vector<double> velocity, force, normal;
  std::size_t missing = 0;
};

ContactSamples read_contact(const SeriesFrictionArguments& arguments) {
  if (arguments.normal.empty() == (arguments.load == 0.0))
    throw InputError({ErrorKind::usage, "", "--normal", "or --load says the normal load, one of them",
                      "give a column, or a constant load in N"});
  records::SeriesOptions options{{arguments.velocity, arguments.force}, arguments.rate_hz, 0};
  if (!arguments.normal.empty()) options.channels.push_back(arguments.normal);
  if (arguments.force_delay == 0.0 && !options.rate_hz) options.rate_hz = 1.0;  // no time is needed
  records::SeriesRecord record = records::read_series(arguments.file, options);
  if (arguments.force_delay != 0.0)
    record.samples[1] = series::advanced(record.samples[1], 1.0 / record.rate_hz, arguments.force_delay);
  ContactSamples out{record.file, {}, {}, {}, 0};
  for (std::size_t i = 0; i < record.samples[0].size(); ++i) {
    const bool there = std::ranges::all_of(record.samples, [i](const auto& channel) { return std::isfinite(channel[i]); });
    out.missing += there ? 0 : 1;
    if (!there) continue;
    out.velocity.push_back(record.samples[0][i]);
    out.force.push_back(record.samples[1][i]);
    out.normal.push_back(arguments.load > 0.0 ? arguments.load : record.samples[2][i]);
  }
  return out;
}

report::Table law_table(const series::FrictionLaw& law) {
  const auto pm = [](double value, double error) { return fmt::format("{} ± {:.1g}", report::number(value, error), error); };
  report::Table table({{"", report::Align::left}, {"", report::Align::left}});
  table.add({"slipping samples", fmt::format("{}", law.slip_samples)});
  table.add({"sticking samples", fmt::format("{}", law.stick_samples)});
  table.add({"μ_K", pm(law.kinetic, law.kinetic_error)});
  if (law.falls) {
    table.add({"μ_S − μ_K", pm(law.drop, law.drop_error)});
    table.add({"α s/m", pm(law.decay, law.decay_error)});
  } else {
    table.add({"falling law", "not better than a constant (AIC)"});
  }
  table.add({"μ_S at least", law.static_bound ? report::number(*law.static_bound) : "–"});
  table.add({"scatter of μ", report::number(law.scatter)});
  return table;
}

std::vector<std::string> remarks_of(const ContactSamples& samples, const series::FrictionLaw& law) {
  std::vector<std::string> out;
  if (samples.missing > 0) out.push_back(fmt::format("{} samples with a missing channel are left out", samples.missing));
  if (!law.remark.empty()) out.push_back(law.remark);
  return out;
}

std::string law_json(const ContactSamples& samples, const series::FrictionLaw& law) {
  report::Json out = {{"status", "ok"},
                      {"slip_samples", law.slip_samples},
                      {"stick_samples", law.stick_samples},
                      {"missing", samples.missing},
                      {"kinetic", report::value(law.kinetic)},
                      {"kinetic_error", report::value(law.kinetic_error)},
                      {"falls", law.falls},
                      {"drop", report::value(law.drop)},
                      {"drop_error", report::value(law.drop_error)},
                      {"decay", report::value(law.decay)},
                      {"decay_error", report::value(law.decay_error)},
                      {"static_bound", report::value(law.static_bound)},
                      {"scatter", report::value(law.scatter)},
                      {"remarks", remarks_of(samples, law)}};
  return report::json_text(out);
}

std::string samples_csv(const ContactSamples& samples) {
  std::string text = report::csv_line({"relative velocity [m/s]", "friction coefficient"});
  for (std::size_t i = 0; i < samples.velocity.size(); ++i)
    text += report::csv_line({report::csv_number(samples.velocity[i]), report::csv_number(samples.force[i] / samples.normal[i])});
  return text;
}

std::string law_page(const ContactSamples& samples, const series::FrictionLaw& law) {
  report::ReportPage page(samples.file, "jointid series friction");
  const std::vector<std::string> remarks = remarks_of(samples, law);
  page.status(report::status_banner(remarks.empty() ? "ok" : "doubtful",
                                    law.falls ? "A law that falls with speed." : "A constant coefficient.", remarks));
  page.section("Law");
  page.add(law_table(law));
  report::ScatterPlot plot;
  plot.title = "Friction coefficient over relative velocity";
  plot.x = {"relative velocity (m/s)", false};
  plot.y = {"f/N", false};
  report::PointGroup points{"samples", {}};
  const std::size_t step = std::max<std::size_t>(1, samples.velocity.size() / report::most_points);
  for (std::size_t i = 0; i < samples.velocity.size(); i += step)
    points.points.push_back({samples.velocity[i], samples.force[i] / samples.normal[i], ""});
  plot.groups.push_back(std::move(points));
  const double most = *std::ranges::max_element(samples.velocity);
  for (int k = 0; k <= 100 && most > 0.0; ++k) {
    const double v = most * k / 100.0;
    plot.front.push_back({v, law.kinetic + law.drop * std::exp(-law.decay * v), ""});
  }
  plot.front_name = "law, forwards";
  page.add(report::PlotGroup{"", {{"", {plot}}}});
  page.add(report::Text{
      "Sticking samples only bound μ_S from below; μ(V) = μ_K + (μ_S − μ_K) exp(−αV) is fitted to slipping samples.", true});
  return page.html();
}

}  // namespace

ExitCode execute(const SeriesFrictionArguments& arguments, std::ostream& out) {
  check_series_targets(arguments.file, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const ContactSamples samples = read_contact(arguments);
  const series::FrictionLaw law =
      series::friction_law({samples.velocity, samples.force, samples.normal}, {arguments.stick_speed, 0.0});
  if (arguments.json) write_target(*arguments.json, law_json(samples, law), out);
  if (arguments.csv) write_target(*arguments.csv, samples_csv(samples), out);
  if (arguments.report) write_target(*arguments.report, law_page(samples, law), out);
  if (takes_output({arguments.json, arguments.csv, arguments.report})) return ExitCode::done;
  for (const std::string& remark : remarks_of(samples, law)) out << "note: " << remark << "\n";
  out << "μ(V) = μ_K + (μ_S − μ_K) exp(−αV)\n" << law_table(law).text();
  return ExitCode::done;
}

}  // namespace jointid::cli
