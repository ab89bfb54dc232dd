#include "cli/stability_arguments.hpp"

#include "cli/command_options.hpp"
#include "cli/whole_number.hpp"

namespace jointid::cli {

void declare(CLI::App& command, StabilityArguments& arguments) {
  command.add_option("--sweeps", arguments.sweeps, "Only these, e.g. stiffness,lines")->delimiter(',');
  add_whole_number(&command, "--scenes", arguments.scenes, "How many extreme scenes to draw at random", counts_of_trials());
  add_whole_number(&command, "--seed", arguments.seed, "Of the scenes", {});
  add_outputs(&command, arguments, "all rows", "all rows", "tables and plots");
  command.footer("Examples:\n  jointid stability\n  jointid stability --sweeps stiffness --scenes 0 --report stability.html");
}

}  // namespace jointid::cli
