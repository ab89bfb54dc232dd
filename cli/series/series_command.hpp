#pragma once

#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/series/series_arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `series` and its commands; choosing one stores it.
void add_series(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const SeriesDelayArguments& arguments, std::ostream& out);
ExitCode execute(const SeriesStrainArguments& arguments, std::ostream& out);
ExitCode execute(const SeriesFrictionArguments& arguments, std::ostream& out);
ExitCode execute(const SeriesReversalArguments& arguments, std::ostream& out);
ExitCode execute(const SeriesAlignArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
