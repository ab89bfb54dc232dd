#pragma once

#include <functional>
#include <span>

#include "study/study_options.hpp"
#include "ident/team/team.hpp"
#include "study/trial_data.hpp"

namespace jointid::study {

/// Progress and stop of a study. The calling thread calls progress and interrupted several times per second.
struct StudyControl {
  std::function<void(std::size_t done, std::size_t total)> progress;
  std::function<bool()> interrupted;
  /// Gets every row that this process computes (study_row.hpp). Any thread may call it, also several at once.
  std::function<void(std::size_t trial, std::span<const double> row)> row = {};
};

struct StudyRun {
  bool complete = false;     ///< OUT is complete; else the study was interrupted, and OUT.partial has the finished trials
  std::size_t done = 0;      ///< trials that are kept
  std::size_t computed = 0;  ///< of them in this run, by all processes
  double wall_s = 0.0;
  double solve_s = 0.0;  ///< mean time of one solution in this process, without drawing the noise; 0 when it solved none
};

/// Runs the missing trials of OUT, those of options.part, on all threads of all processes of the team. Each trial is a row of OUT
/// (frf/table_file.hpp): status, unknowns, per judged matrix RJCF, ARVF and rms relative error, and both ends of the 95 %
/// intervals if the method has them (trial 0 decides). The file has the same bytes for any number of threads, processes and
/// interruptions. Only the leader of a team writes, and only its StudyRun is complete. Throws InputError, and ToldElsewhere if
/// another process of the team throws it.
StudyRun run_study(const std::shared_ptr<const TrialData>& data, const StudyOptions& options, ident::Team& team,
                   const StudyControl& control = {});

}  // namespace jointid::study
