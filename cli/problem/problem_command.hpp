#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "problems/case/write_options.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ProblemListArguments {};

struct ProblemWriteArguments {
  std::string name;
  std::filesystem::path directory;
  problems::WriteOptions options;
};

/// Declares `problem list` and `problem write`; choosing one stores it.
void add_problem(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const ProblemListArguments& arguments, std::ostream& out);
ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
