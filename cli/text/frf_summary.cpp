#include "cli/text/frf_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/options/dof_list.hpp"
#include "cli/text/line_pieces.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
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

std::string covariance_text(const FrfCensus& census) {
  if (!census.covariance) return {};
  const char* between = census.references ? "responses and between references" : "responses";
  if (census.factor.rank == 0) return fmt::format(", covariance between {}", between);
  return fmt::format(", covariance between {} of rank {}{}", between, census.factor.rank,
                     census.factor.diagonal ? " plus a diagonal" : "");
}

std::string noise_text(const frf::FrfHeader& header, const FrfCensus& census) {
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

std::string missing_text(const FrfCensus& census) {
  if (census.missing == 0) return "none";
  const double percent = 100.0 * static_cast<double>(census.missing) / static_cast<double>(census.values);
  return fmt::format("{} of {} values ({:.3g} %)", census.missing, census.values, percent);
}

}  // namespace

FrfCensus take_census(frf::FrfSource& source, const std::function<bool()>& interrupted) {
  const frf::FrfHeader& header = source.header();
  std::vector<char> nonzero(header.entries(), 0);
  std::vector<Complex> values;
  FrfCensus census;
  census.covariance = source.has_covariance();
  census.references = source.has_reference_correlation();
  census.factor = source.factor_shape();
  census.complete = for_each_piece(header, lines_per_piece(header), [&](const frf::Block& block) {
    if (interrupted()) return false;
    values.resize(block.size());
    source.read(block, values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool missing = std::isnan(values[i].real()) || std::isnan(values[i].imag());
      census.missing += missing ? 1 : 0;
      if (!missing && values[i] != Complex(0.0)) nonzero[i % header.entries()] = 1;
    }
    census.values += values.size();
    return true;
  });
  census.zero_frfs = static_cast<std::size_t>(std::ranges::count(nonzero, char{0}));
  return census;
}

std::string summary_text(const frf::FrfHeader& header, const FrfCensus& census) {
  report::Table table({{"", report::Align::left}, {"", report::Align::left}});
  table.add({"quantity", frf::name(header.quantity)});
  table.add({"lines", lines_text(header.frequency_hz)});
  table.add({"responses", dof_list(header.response)});
  table.add({"references", dof_list(header.reference)});
  table.add({"node positions", fmt::format("{}", header.nodes.size())});
  table.add({"noise record", noise_text(header, census)});
  table.add({"not measured", missing_text(census)});
  table.add({"FRFs without a value", fmt::format("{} of {}", census.zero_frfs, header.entries())});
  return table.text();
}

}  // namespace jointid::cli
