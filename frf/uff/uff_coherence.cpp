#include "frf/uff/uff_coherence.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

using Coordinates = std::pair<std::int64_t, std::int64_t>;

Coordinates coordinates(const Header58& header) {
  return {coordinate_key(header.response.dof()), coordinate_key(header.reference.dof())};
}

/// Uneven records are compared with the axis when they are read.
bool usable(const Dataset& dataset, const std::vector<double>& axis) {
  const Header58& header = *dataset.function;
  if (header.function_type != function_coherence || header.response.direction == 0 ||
      header.reference.direction == 0 || header.points != axis.size()) {
    return false;
  }
  if (!header.even) return true;
  std::vector<double> own = even_abscissa(header);
  const double to_hz = abscissa_to_hz(header, dataset.place);
  for (double& line : own) line *= to_hz;
  return same_axis(axis, own);
}

/// The number next to the word "average" or "averages" in a line, 0 if there is none.
double averages_in(std::string line) {
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::isalnum(c) ? std::tolower(c) : ' '); });
  const auto fields = words(line);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != "average" && fields[i] != "averages") continue;
    for (const std::size_t beside : {i + 1, i - 1}) {
      const auto count = beside < fields.size() ? parse_integer(fields[beside]) : std::nullopt;
      if (count && *count > 0) return static_cast<double>(*count);
    }
  }
  return 0.0;
}

}  // namespace

void attach_coherences(ByteFile& file, Catalogue& catalogue) {
  std::map<Coordinates, std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < catalogue.datasets.size(); ++i) {
    const Dataset& dataset = catalogue.datasets[i];
    if (dataset.function && usable(dataset, catalogue.header.frequency_hz)) {
      found[coordinates(*dataset.function)].push_back(i);
    }
  }
  for (const auto& [at, record] : catalogue.grid) {
    const auto match = found.find(coordinates(*catalogue.datasets[record.dataset].function));
    if (match == found.end() || match->second.size() != 1) return;
  }
  std::size_t first = npos;
  for (auto& [at, record] : catalogue.grid) {
    record.coherence = found.at(coordinates(*catalogue.datasets[record.dataset].function)).front();
    require_readable(catalogue.datasets[record.coherence]);
    require_plausible_size(file, catalogue.datasets[record.coherence]);
    first = std::min(first, record.coherence);
  }
  catalogue.header.noise = NoiseRecord::coherence;
  for (const std::string& line : catalogue.datasets[first].function->id) {
    if (catalogue.header.averages == 0.0) catalogue.header.averages = averages_in(line);
  }
}

}  // namespace jointid::frf::uff
