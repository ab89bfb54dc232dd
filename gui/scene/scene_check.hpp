#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::gui {

/// What is wrong with a scene's text, and on which line (from 1; 0: of the whole).
struct SceneError {
  int line = 0;
  std::string problem, remedy;
};

/// The scene that a text says, or why it says none.
struct CheckedScene {
  std::optional<ident::Scene> scene;
  std::optional<SceneError> error;
  /// What can be read of a text that says no scene (ident::parse_readable()).
  std::optional<ident::Scene> readable{};

  /// The files and all else that can be looked at, whatever is wrong.
  const std::optional<ident::Scene>& seen() const { return scene ? scene : readable; }
};

/// Asks the library's own reader; `file` resolves the paths of the data.
CheckedScene check_scene(const std::string& text, const std::filesystem::path& file);

/// An error of a plan or a file, at the line of the text that the error names, or that holds the key in its place ("[joint]
/// dofs").
SceneError located(const InputError& error, const std::string& text);

}  // namespace jointid::gui
