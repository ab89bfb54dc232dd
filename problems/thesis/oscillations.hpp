#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jointid::problems {

/// A friction-excited system of Kappagantu's thesis (1997) as a scene of `jointid oscillate`.
struct Oscillation {
  std::string name;  ///< "chain-10", "chain-3", "cantilever", "cantilever-rigid"
  std::string description;
};

const std::vector<Oscillation>& list_oscillations();

/// The one of that name, or null.
const Oscillation* find_oscillation(const std::string& name);

/// Writes NAME.toml and truth.json with what the thesis prints; the path of the scene.
std::filesystem::path write(const Oscillation& problem, const std::filesystem::path& directory);

}  // namespace jointid::problems
