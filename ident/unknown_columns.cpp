#include "ident/unknown_columns.hpp"

#include <algorithm>
#include <set>

namespace jointid::ident {

UnknownColumns::UnknownColumns(const restrictions::Restriction& restriction,
                               const std::vector<restrictions::JointSpec>& joints) {
  std::set<double> limits;
  for (std::size_t u = 0; u < restriction.unknowns.size(); ++u) {
    Place place{unknown_of_.size(), joints[restriction.unknowns[u].joint].bands_hz};
    for (const Range& band : place.bands) {
      unknown_of_.push_back(u);
      band_of_.emplace_back(band);
      limits.insert({band[0], band[1]});
    }
    if (place.bands.empty()) {
      unknown_of_.push_back(u);
      band_of_.emplace_back();
    }
    places_.push_back(std::move(place));
  }
  limits_hz_.assign(limits.begin(), limits.end());
}

std::vector<std::size_t> UnknownColumns::at(double frequency_hz) const {
  std::vector<std::size_t> columns;
  for (const Place& place : places_) {
    const auto band = std::find_if(place.bands.begin(), place.bands.end(), [&](const Range& range) {
      return frequency_hz >= range[0] && frequency_hz < range[1];
    });
    if (band == place.bands.end() && !place.bands.empty()) return {};
    columns.push_back(place.first_column + static_cast<std::size_t>(band - place.bands.begin()));
  }
  return columns;
}

}  // namespace jointid::ident
