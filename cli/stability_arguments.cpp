#include "cli/stability_arguments.hpp"

#include "cli/command_options.hpp"

namespace jointid::cli {

void declare(CLI::App& command, StabilityArguments& arguments) {
  command.add_option("--sweeps", arguments.sweeps, "Only these, e.g. stiffness,lines")->delimiter(',');
  command.add_option("--scenes", arguments.scenes, "How many extreme scenes to draw at random")->check(CLI::NonNegativeNumber)->capture_default_str();
  command.add_option("--seed", arguments.seed, "Of the scenes")->check(CLI::NonNegativeNumber)->capture_default_str();
  add_outputs(&command, arguments, "all rows", "all rows", "tables and plots");
  command.footer("Examples:\n  jointid stability\n  jointid stability --sweeps stiffness --scenes 0 --report stability.html");
}

}  // namespace jointid::cli
