#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"
#include "cli/resume/resume_options.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ResponseArguments {
  std::filesystem::path scene;
  Target json{}, csv{}, report{}, curves{}, history{}, out{};
  bool compare = false;
  ResumeOptions resume{};
};

/// Declares `response`; choosing it stores it.
void add_response(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const ResponseArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
