#pragma once

#include <functional>
#include <span>

#include "study/study_options.hpp"
#include "ident/team/team.hpp"
#include "study/trial_data.hpp"

namespace jointid::study {

/// How the caller watches and stops a study; progress and interrupted are called several times per second by the calling thread.
struct StudyControl {
  std::function<void(std::size_t done, std::size_t total)> progress;
  std::function<bool()> interrupted;
  /// Given every row that this process computes as it is kept (study_row.hpp); called by any thread, by several at once.
  std::function<void(std::size_t trial, std::span<const double> row)> row = {};
};

struct StudyRun {
  bool complete = false;     ///< OUT is there; else it was interrupted, and OUT.partial has what is done
  std::size_t done = 0;      ///< trials that are kept
  std::size_t computed = 0;  ///< of them in this run, by all processes
  double wall_s = 0.0;
  double solve_s = 0.0;  ///< mean time of one solution in this process, without drawing the noise; 0 when it solved none
};

/// Runs the trials that OUT lacks on all threads of all processes of the team. One row per trial goes to OUT (frf/table_file.hpp):
/// status, unknowns, per judged matrix RJCF, ARVF and rms relative error, and both ends of the 95 % intervals when the method
/// has them (trial 0 tells). The file has the same bytes for any number of threads, processes and interruptions.
/// Only the leader of a team writes, and only its StudyRun tells of all. Throws InputError, and ToldElsewhere where another
/// process of the team throws it.
StudyRun run_study(const std::shared_ptr<const TrialData>& data, const StudyOptions& options, ident::Team& team,
                   const StudyControl& control = {});

}  // namespace jointid::study
