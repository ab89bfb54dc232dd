#pragma once

#include <filesystem>
#include <optional>

#include "cli/options/target.hpp"
#include "tasks/frf/run_frf.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct FrfArguments : tasks::FrfTask {
  std::optional<std::filesystem::path> output;
  Target json, csv, report;
};

/// Declares the options of `jointid frf` on its command.
void declare(CLI::App& command, FrfArguments& arguments);

}  // namespace jointid::cli
