#include "coupling/assembly.hpp"

namespace jointid::coupling {

PlacedDof parse_placed_dof(const std::string& text) {
  const std::size_t slash = text.rfind('/');
  if (slash == std::string::npos) return {{}, frf::Dof::parse(text)};
  return {text.substr(0, slash), frf::Dof::parse(text.substr(slash + 1))};
}

}  // namespace jointid::coupling
