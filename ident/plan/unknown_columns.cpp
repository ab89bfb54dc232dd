#include "ident/plan/unknown_columns.hpp"

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
  columns.reserve(places_.size());
  for (const Place& place : places_) {
    const auto band = std::find_if(place.bands.begin(), place.bands.end(), [&](const Range& range) {
      return frequency_hz >= range[0] && frequency_hz < range[1];
    });
    if (band == place.bands.end() && !place.bands.empty()) return {};
    columns.push_back(place.first_column + static_cast<std::size_t>(band - place.bands.begin()));
  }
  return columns;
}

std::string UnknownColumns::name(std::size_t column, const restrictions::Restriction& restriction) const {
  std::string text = restriction.unknowns[unknown_of_[column]].name;
  const auto number = [](double value) {
    std::string digits = std::to_string(value);
    digits.erase(digits.find_last_not_of('0') + 1);
    if (digits.back() == '.') digits.pop_back();
    return digits;
  };
  if (const auto band = band_of_[column]) text += "@" + number((*band)[0]) + "-" + number((*band)[1]) + "Hz";
  return text;
}

}  // namespace jointid::ident
