#pragma once

#include <ostream>
#include <string>

#include "cli/compare/compare_arguments.hpp"
#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// The ways to find friction joints on the text of a scene of them.
ExitCode compare_law_scene(const CompareArguments& arguments, const std::string& text, std::ostream& out);

}  // namespace jointid::cli
