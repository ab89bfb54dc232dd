#pragma once

#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/pod/pod_arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `pod`; choosing it stores it.
void add_pod(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const PodArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
