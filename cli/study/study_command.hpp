#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct StudyArguments {
  static constexpr bool is_shared = true;
  std::filesystem::path scene, out;  ///< out: empty for the scene's name with .study.h5 in the current folder
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< 0: all cores
  bool resume = false;
  std::string part;                          ///< "3/16": of this part alone
  std::vector<std::filesystem::path> merge;  ///< files of all parts, in place of trials
  std::optional<double> stop_before;         ///< s of wall time
  Target json, csv, report;
  std::string units = "SI";  ///< of text, CSV and page: SI or mm
};

/// Declares `study`; choosing it stores it.
void add_study(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const StudyArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
