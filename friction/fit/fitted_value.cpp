#include "friction/fit/fitted_value.hpp"

namespace jointid::friction {

std::string name(Knowledge knowledge) {
  constexpr std::array names = {"determined", "extrapolated", "undetermined", "preset"};
  return names[static_cast<std::size_t>(knowledge)];
}

}  // namespace jointid::friction
