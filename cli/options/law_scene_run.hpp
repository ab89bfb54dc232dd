#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// Runs a command on the text of a scene of friction laws, or of the joint at every line; null in the program that leaves those to
/// jointid-all.
template <class Arguments>
using LawSceneRun = ExitCode (*)(const Arguments& arguments, const std::string& text, std::ostream& out);

/// Whether a scene is one of those that jointid-all runs.
bool is_law_or_line_scene(const std::string& text, const std::filesystem::path& scene);

/// Whether jointid-all is there and the scene one of these, or a pipe, which can be read once only.
bool needs_laws(const std::filesystem::path& scene);

/// Throws InputError (usage): this program runs no such scenes, and jointid-all is missing.
[[noreturn]] void refuse_law_scene(const std::filesystem::path& scene);

template <class Arguments>
ExitCode run_law_scene(const Arguments& arguments, const std::string& text, std::ostream& out) {
  if (arguments.run_laws == nullptr) refuse_law_scene(arguments.scene);
  return arguments.run_laws(arguments, text, out);
}

}  // namespace jointid::cli
