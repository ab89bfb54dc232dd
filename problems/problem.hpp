#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "frf/frf_set.hpp"

namespace jointid::problems {

/// A problem with a known answer: noise-free and polluted FRFs, the scene that identifies it, and the truth.
struct Problem {
  std::string name;         ///< "A1"
  std::string description;  ///< one line, with the thesis section
  std::vector<frf::FrfSet> substructures;  ///< noise-free; their cross FRFs are zero by construction
  frf::FrfSet assembly;                    ///< noise-free
  std::string scene;  ///< TOML text; its [data] names the files that write() makes, its [truth] the exact matrices
};

struct ProblemInfo {
  std::string name;
  std::string description;
};

/// All built-in problems in the order of the thesis.
std::vector<ProblemInfo> list();

/// Builds one; throws InputError (usage) with the nearest name when there is none.
Problem make(const std::string& name);

struct WriteOptions {
  std::string format = "h5";  ///< "h5" or "uff"
  std::uint64_t seed = 1;     ///< of the noise that the case is defined with
  bool clean = false;         ///< leave the noise out
};

/// Writes the FRF files, NAME.toml and truth.json into `directory` (made if absent) and returns the scene's path.
std::filesystem::path write(const Problem& problem, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
