#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "cli/problem/problem_kind.hpp"
#include "problems/case/write_options.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ProblemListArguments {
  ProblemKinds kinds;
};

struct ProblemWriteArguments {
  std::string name;
  std::filesystem::path directory;
  problems::WriteOptions options;
  ProblemKinds kinds;
};

/// Declares `problem list` and `problem write`; choosing one stores it.
void declare_problem(CLI::App& app, Chosen& chosen, const ProblemKinds& kinds);

/// Whether jointid-all is there and only it can: for the whole list, and for problems that are not among `kinds`.
bool is_elsewhere(const ProblemListArguments& arguments);
bool is_elsewhere(const ProblemWriteArguments& arguments);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const ProblemListArguments& arguments, std::ostream& out);
ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
