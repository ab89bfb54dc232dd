#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/target.hpp"
#include "study/comparison.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct CompareArguments {
  std::filesystem::path scene;  ///< empty with `reproduce`
  std::string reproduce;        ///< number of a thesis table, or "list"; empty with `scene`
  std::size_t trials = 200;
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< 0: all cores
  std::vector<std::string> methods, weightings, solvers, regenerate;
  std::vector<double> deltas;
  std::string equations;  ///< sets of names, separated by ";"
  Target json, csv, report;
};

/// Declares the options of `jointid compare` on its command.
void declare(CLI::App& command, CompareArguments& arguments);

/// What the lists of the command line name. Throws InputError (usage) that names the option, the word and the nearest valid one.
study::Alternatives alternatives(const CompareArguments& arguments);

/// Throws InputError (usage) for a command line that cannot be carried out.
void check(const CompareArguments& arguments);

/// Throws InputError (usage) that names a list, as scenes of friction laws have ways of their own.
void refuse_alternatives(const CompareArguments& arguments);

}  // namespace jointid::cli
