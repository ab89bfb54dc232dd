#pragma once

#include <string>
#include <vector>

#include "ident/scene/couple_scene.hpp"
#include "ident/scene/equivalent_scene.hpp"

namespace jointid::ident {

/// A file that is read, and what says so: "the scene", "[data] assembly".
struct NamedFile {
  Path path;
  std::string place;
};

/// The scene and every file that it names, runs of repeats one by one.
std::vector<NamedFile> files_of(const Scene& scene);
std::vector<NamedFile> files_of(const CoupleScene& scene);
std::vector<NamedFile> files_of(const EquivalentScene& scene);

}  // namespace jointid::ident
