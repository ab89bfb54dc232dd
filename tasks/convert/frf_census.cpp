#include "tasks/convert/frf_census.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "frf/noise/turned_points.hpp"
#include "tasks/convert/line_pieces.hpp"

namespace jointid::tasks {

FrfCensus take_census(frf::FrfSource& source, const std::function<bool()>& interrupted) {
  const frf::FrfHeader& header = source.header();
  std::vector<char> nonzero(header.entries(), 0);
  std::vector<Complex> values;
  FrfCensus census;
  census.covariance = source.has_covariance();
  census.references = source.has_reference_correlation();
  census.factor = source.factor_shape();
  std::optional<frf::WildSearch> wild;
  frf::TurnedPoints turned(header);
  if (header.entries() <= frf::most_judged_frfs) wild.emplace(header);
  census.complete = for_each_piece(header, lines_per_piece(header), [&](const frf::Block& block) {
    if (interrupted && interrupted()) return false;
    values.resize(block.size());
    source.read(block, values);
    if (wild) wild->add(values);
    turned.add(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool missing = std::isnan(values[i].real()) || std::isnan(values[i].imag());
      census.missing += missing ? 1 : 0;
      if (!missing && values[i] != Complex(0.0)) nonzero[i % header.entries()] = 1;
    }
    census.values += values.size();
    return true;
  });
  census.wild = wild ? wild->finish() : frf::WildValues{.found = {}, .more = 0, .looked = false};
  census.turned = turned.found();
  census.zero_frfs = static_cast<std::size_t>(std::ranges::count(nonzero, char{0}));
  return census;
}

}  // namespace jointid::tasks
