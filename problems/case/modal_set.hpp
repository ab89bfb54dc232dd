#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "frf/noise/noise.hpp"
#include "frf/set/frf_set.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"
#include "problems/structure/modes.hpp"

namespace jointid::problems {

/// FRFs of known modes, for modal fits: docs/formulas.md §9 (5.65) with real shapes and hysteretic damping, nothing outside the range.
struct ModalSet {
  std::string name, description;
  Modes modes;
  frf::FrfSet clean;
  frf::NoiseModel noise;  ///< circular, 1 %, the variances on record
};

std::vector<ProblemInfo> list_modal_sets();

/// Throws InputError (usage) with the nearest name when there is none.
ModalSet make_modal_set(const std::string& name);

/// The set with the noise of trial 0 of a seed and so on.
frf::FrfSet polluted(const ModalSet& set, std::uint64_t seed, std::uint64_t trial);

/// Writes the FRF file and truth.json (natural frequencies, loss factors) into `directory`, made if absent; returns the file's path.
std::filesystem::path write(const ModalSet& set, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
