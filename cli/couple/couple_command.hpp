#pragma once

#include <cstddef>
#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct CoupleArguments {
  std::filesystem::path scene, out;  ///< out: empty for the scene's name with .coupled.h5 in the current folder
  bool bounds = false;
  std::size_t threads = 0;  ///< 0: all cores
  Target json, csv, report;
  std::string units = "SI";             ///< of the FRFs of the page: SI or mm
  std::string quantity = "receptance";  ///< of these: receptance, mobility, accelerance or measured
};

/// Declares `couple`; choosing it stores it.
void add_couple(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const CoupleArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
