#include "frf/uff/uff_catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "frf/uff/uff_units.hpp"

namespace jointid::frf::uff {

void require_axis(const Catalogue& catalogue, const Dataset& dataset, std::vector<double> abscissa) {
  const double to_hz = abscissa_to_hz(*dataset.function, dataset.place);
  for (double& line : abscissa) line *= to_hz;
  if (same_axis(catalogue.header.frequency_hz, abscissa)) return;
  const auto range = [](const std::vector<double>& axis) {
    return std::to_string(axis.front()) + " to " + std::to_string(axis.back()) + " Hz";
  };
  dataset.place.fail("frequency axis",
                     range(abscissa) + " but " + catalogue.datasets[catalogue.first_record].place.dataset +
                         " has " + range(catalogue.header.frequency_hz) +
                         ", with lines that differ by 0.1 of a spacing or more",
                     "put FRFs with different axes into different files");
}

bool same_axis(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double below = i > 0 ? a[i] - a[i - 1] : std::numeric_limits<double>::infinity();
    const double above = i + 1 < a.size() ? a[i + 1] - a[i] : std::numeric_limits<double>::infinity();
    const double spacing = a.size() > 1 ? std::min(below, above) : 1e-5 * std::abs(a[i]);
    if (a[i] != b[i] && !(std::abs(a[i] - b[i]) < 0.1 * spacing)) return false;
  }
  return true;
}

}  // namespace jointid::frf::uff
