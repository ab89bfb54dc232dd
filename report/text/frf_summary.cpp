#include "report/text/frf_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "frf/noise/turned_points.hpp"
#include "frf/set/line_scale.hpp"
#include "report/text/dof_list.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::string lines_text(const std::vector<double>& hz) {
  std::string text = fmt::format("{}, {:g} to {:g} Hz", hz.size(), hz.front(), hz.back());
  if (hz.size() < 2) return text;
  const double step = (hz.back() - hz.front()) / static_cast<double>(hz.size() - 1);
  for (std::size_t i = 1; i < hz.size(); ++i) {
    if (std::abs(hz[i] - hz[i - 1] - step) > 1e-3 * step) return text + ", steps vary";
  }
  return text + fmt::format(", step {:g} Hz", step);
}

std::string covariance_text(const tasks::FrfCensus& census) {
  if (!census.covariance) return {};
  const char* between = census.references ? "responses and between references" : "responses";
  if (census.factor.rank == 0) return fmt::format(", covariance between {}", between);
  return fmt::format(", covariance between {} of rank {}{}", between, census.factor.rank,
                     census.factor.diagonal ? " plus a diagonal" : "");
}

std::string noise_text(const frf::FrfHeader& header, const tasks::FrfCensus& census) {
  switch (header.noise) {
    case frf::NoiseRecord::variance:
      return "variance of real and imaginary part" + covariance_text(census);
    case frf::NoiseRecord::coherence:
      return fmt::format("coherence, {:g} averages", header.averages);
    case frf::NoiseRecord::none:
      break;
  }
  return "none";
}

std::string missing_text(const tasks::FrfCensus& census) {
  if (census.missing == 0) return "none";
  const double percent = 100.0 * static_cast<double>(census.missing) / static_cast<double>(census.values);
  return fmt::format("{} of {} values ({:.3g} %)", census.missing, census.values, percent);
}

constexpr std::size_t most_shown = 12;

std::string place_text(const frf::FrfHeader& header, const frf::WildValue& wild) {
  const std::string frf = wild.response == frf::npos
                              ? "all FRFs"
                              : header.response[wild.response].name() + "/" + header.reference[wild.reference].name();
  if (wild.line == wild.last_line)
    return fmt::format("{}, line {} ({:g} Hz)", frf, wild.line + 1, header.frequency_hz[wild.line]);
  return fmt::format("{}, lines {} to {} ({:g} to {:g} Hz)", frf, wild.line + 1, wild.last_line + 1,
                     header.frequency_hz[wild.line], header.frequency_hz[wild.last_line]);
}

std::string what_text(const frf::FrfHeader& header, const frf::WildValue& wild) {
  if (wild.kind == frf::WildKind::not_a_number) return "not a number";
  if (wild.kind == frf::WildKind::infinite) return "infinite";
  const Complex stored = frf::LineScale::from_receptance(header.quantity, header.frequency_hz[wild.line]).value(wild.value);
  return fmt::format("{:.2g} times its neighbours: {:.4g}{:+.4g}i {}", wild.factor, stored.real() + 0.0, stored.imag() + 0.0,
                     frf::unit(header.quantity));
}

/// Most of a file's gaps are whole FRFs, which the table counts.
std::string wild_text(const frf::FrfHeader& header, const frf::WildValues& wild) {
  if (!wild.looked) return fmt::format("values that stand out: not looked for in more than {} FRFs\n", frf::most_judged_frfs);
  if (wild.found.empty()) return {};
  std::string text = "values that are no FRF of a structure\n";
  for (std::size_t i = 0; i < std::min(most_shown, wild.found.size()); ++i)
    text += "  " + place_text(header, wild.found[i]) + ": " + what_text(header, wild.found[i]) + "\n";
  const std::size_t more = wild.found.size() + wild.more - std::min(most_shown, wild.found.size());
  return more == 0 ? text : text + fmt::format("  and {} more\n", more);
}

}  // namespace

std::string summary_text(const frf::FrfHeader& header, const tasks::FrfCensus& census) {
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"quantity", frf::name(header.quantity)});
  table.add({"lines", lines_text(header.frequency_hz)});
  table.add({"responses", dof_list(header.response)});
  table.add({"references", dof_list(header.reference)});
  table.add({"node positions", fmt::format("{}", header.nodes.size())});
  table.add({"noise record", noise_text(header, census)});
  table.add({"not measured", missing_text(census)});
  table.add({"FRFs without a value", fmt::format("{} of {}", census.zero_frfs, header.entries())});
  const std::string turned = frf::turned_points_text(census.turned);
  return table.text() + wild_text(header, census.wild) + (turned.empty() ? "" : "note: " + turned + "\n");
}

}  // namespace jointid::report
