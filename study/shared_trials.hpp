#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "frf/hdf5/record_journal.hpp"
#include "ident/team/team.hpp"

namespace jointid::study {

/// Makes the trial of a number as a row of numbers, which is what processes send; `row` is what it made last.
using MakeTrialRow = std::function<void(std::size_t trial, std::vector<double>& row)>;

/// What a process of a team does for the trials of a study, whatever they are of.
struct TrialSharing {
  std::size_t threads = 1;               ///< of this process
  std::function<MakeTrialRow()> maker;   ///< of one thread, made in it; it may throw Interrupted
  /// In the leader: every trial, its own and those of the others, by any thread, by several at once.
  std::function<void(std::size_t trial, std::span<const double> row)> keep;
  std::function<bool()> interrupted{};               ///< asked several times per second by the calling thread
  std::function<void(std::size_t made)> watch{};     ///< in the leader, as often: how many trials all have made
};

/// Makes the leader's `missing` trials, each process a part of them on threads of its own, and returns how many were made: in the leader
/// by all, in the others by themselves. Every process calls it; those beside the leader are given `missing` here. Where it was
/// interrupted there are fewer. In the leader it throws what making or keeping a trial throws, and InputError when another process fails;
/// the others throw nothing.
std::size_t share_trials(std::vector<frf::IndexRange> missing, ident::Team& team, const TrialSharing& sharing);

}  // namespace jointid::study
