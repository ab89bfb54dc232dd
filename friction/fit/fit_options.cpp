#include "friction/fit/fit_options.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace jointid::friction {
namespace {

constexpr std::array weighting_names = {"none", "largest", "relative", "travel"};

}  // namespace

std::string name(Weighting weighting) { return weighting_names[static_cast<std::size_t>(weighting)]; }

Weighting parse_weighting(const std::string& word) {
  const auto found = std::ranges::find(weighting_names, word);
  if (found == weighting_names.end()) refuse("no weighting '" + word + "'; valid: none, largest, relative, travel");
  return static_cast<Weighting>(found - weighting_names.begin());
}

}  // namespace jointid::friction
