#pragma once

#include <filesystem>
#include <string>

namespace jointid::python {

/// The text of a scene, and the path by which messages name it and its files are found.
struct SceneText {
  std::string text;
  std::filesystem::path file;
};

}  // namespace jointid::python
