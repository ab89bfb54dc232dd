#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cli/exit_code.hpp"
#include "cli/loading_curve_arguments.hpp"
#include "frf/frf_source.hpp"
#include "modalfit/fit.hpp"
#include "problems/problem.hpp"

namespace jointid::cli {

/// Where a result goes: a file name, or "-" for standard output.
using Target = std::optional<std::string>;

struct InfoArguments {
  std::filesystem::path file;
  frf::OpenOptions open;
};

struct ConvertArguments {
  std::vector<std::filesystem::path> in;
  std::filesystem::path out;
  frf::OpenOptions open;
};

struct ProblemListArguments {};

struct ProblemWriteArguments {
  std::string name;
  std::filesystem::path directory;
  problems::WriteOptions options;
};

struct SolveArguments {
  std::filesystem::path scene;
  Target json, csv;
  Target report;  ///< HTML
  std::optional<std::string> plot;  ///< RESPONSE/REFERENCE of an assembly FRF
};

struct PlanArguments {
  std::filesystem::path scene;
  bool bound = false;                ///< predict standard errors
  std::vector<frf::Dof> candidates;  ///< coordinates that are not there yet; only with `bound`
  Target json;
};

struct CheckArguments {
  std::filesystem::path scene;
  Target json;
};

struct StudyArguments {
  std::filesystem::path scene, out;  ///< out: empty for the scene's name with .study.h5 in the current folder
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< 0: all cores
  bool resume = false;
  Target json, csv, report;
};

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

struct CoupleArguments {
  std::filesystem::path scene, out;  ///< out: empty for the scene's name with .coupled.h5 in the current folder
  bool bounds = false;
  std::size_t threads = 0;  ///< 0: all cores
  Target json, csv, report;
};

struct EquivalentArguments {
  std::filesystem::path scene;
  Target json, csv;
};

struct ModalfitArguments {
  std::vector<std::filesystem::path> files;
  frf::OpenOptions open;
  modalfit::FitOptions fit;
  std::optional<std::filesystem::path> regenerate, shapes;
  Target json, csv, report;
};

struct StabilityArguments {
  std::vector<std::string> sweeps;  ///< by name; empty: all
  std::size_t scenes = 200;         ///< drawn at random
  std::uint64_t seed = 1;
  Target json, csv, report;
};

using Arguments = std::variant<InfoArguments, ConvertArguments, ProblemListArguments, ProblemWriteArguments,
                               SolveArguments, PlanArguments, StudyArguments, CompareArguments, LoadingCurveArguments, CoupleArguments,
                               EquivalentArguments, ModalfitArguments, StabilityArguments, CheckArguments>;

/// What to print instead of doing anything: help, version or what is wrong with the command line.
struct Notice {
  ExitCode code = ExitCode::done;
  std::string text;  ///< for stdout when the code is `done`, else one line for stderr
};

/// Reads the command line.
std::variant<Arguments, Notice> parse(int argc, const char* const* argv);

}  // namespace jointid::cli
