#include "cli/options/law_scene_run.hpp"

#include "base/error.hpp"
#include "cli/options/complete_program.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"

namespace jointid::cli {

bool is_law_or_line_scene(const std::string& text, const std::filesystem::path& scene) {
  return scene::is_law_scene(text, scene) || scene::is_line_scene(text, scene);
}

bool needs_laws(const std::filesystem::path& scene) {
  if (!complete_program()) return false;
  std::error_code unknown;
  if (std::filesystem::exists(scene, unknown) && !std::filesystem::is_regular_file(scene, unknown)) return true;
  try {
    return is_law_or_line_scene(scene::read_text(scene), scene);
  } catch (const InputError&) {
    return false;  // the command says it
  }
}

void refuse_law_scene(const std::filesystem::path& scene) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = scene.string(),
                    .place = {},
                    .problem = "it is a scene of friction laws or of a joint at every line, which this part of jointid does not solve",
                    .remedy = how_to_complete});
}

}  // namespace jointid::cli
