#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "ident/scene/scene.hpp"

namespace jointid::study {

/// Which of the parts of a study that run one by one, on machines of a cluster for example.
struct StudyPart {
  std::size_t number = 1, count = 1;  ///< 1 ≤ number ≤ count
};

struct StudyOptions {
  std::size_t trials = 1000;  ///< ≥ 1; trial numbers 0 … trials−1
  StudyPart part = {};        ///< the trials of this part alone (study_records.hpp); OUT then has these
  std::uint64_t seed = 1;
  std::size_t threads = 0;  ///< per process; 0: all cores. The result does not depend on it.
  bool resume = false;      ///< take up what a run of the same study left, interrupted or of fewer trials
  ident::Path out;                 ///< the result; until it is complete the trials are in OUT.partial
  std::map<std::string, std::string> texts;  ///< what else the results depend on (scene, version): kept in the file
};

/// OUT.partial.
inline ident::Path journal_path(const ident::Path& out) { return out.string() + ".partial"; }

}  // namespace jointid::study
