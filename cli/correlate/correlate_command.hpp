#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct CorrelateArguments {
  std::filesystem::path one, other;
  bool modes = false;  ///< shapes in place of FRFs
  std::string fdac;    ///< a reference; empty: none
  Target json, csv;
};

struct ExpandArguments {
  std::filesystem::path parent, measured, out;
  std::string way = "extended";
  std::size_t modes = 0;  ///< 0: all
  Target json;
};

/// Declares `correlate` and `expand`; choosing one stores it.
void add_correlate(CLI::App& app, Chosen& chosen);
void add_expand(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const CorrelateArguments& arguments, std::ostream& out);
ExitCode execute(const ExpandArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
