#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// The system of thesis §3.6.1: two cantilevers of five and four beam elements (18 coordinates, translation and rotation of each
/// node), a joint between coordinates 5 and 13 and one from 7 to ground, both of a type of Table 3.1, and a force p sin 100πt
/// at 5. Sections and lengths stand in figure 3.4 alone; these are those of chapter 6 with elements of 0.1325 m.
struct TwoBeams {
  std::string name;  ///< "beams-A" … "beams-E"
  std::string description;
  std::string law;
  std::vector<double> parameters;  ///< as printed in Table 3.1
};

const std::vector<TwoBeams>& list_two_beams();

/// The one of that name, or null.
const TwoBeams* find_two_beams(const std::string& name);

/// 18 × 18, without the joints.
Matrix two_beams_mass();
Matrix two_beams_stiffness();

/// Writes NAME.toml, the matrices as Matrix Market files and truth.json; the path of the scene.
std::filesystem::path write(const TwoBeams& problem, const std::filesystem::path& directory);

}  // namespace jointid::problems
