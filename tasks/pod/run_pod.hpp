#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "ident/team/team.hpp"
#include "series/pod/pod.hpp"
#include "tasks/pod/pod_record.hpp"
#include "tasks/pod/pod_task.hpp"

namespace jointid::tasks {

/// All that run_pod() finds of n channels.
struct PodResult {
  std::vector<std::string> names, units;  ///< of the channels
  std::size_t cut = 0;                    ///< samples of longer channels that were left out, of all channels together
  series::Pod pod;                        ///< modes [n, n], values and means in the units of the channels
  bool weighted = false, mean_kept = false;
  std::string compared;                ///< "the modes of --compare", "the normal modes of --stiffness and --mass"; or empty
  Eigen::MatrixXd cosines, assurance;  ///< cosines and MAC, [modes, those that they are compared with]; empty without them
  std::vector<double> frequencies_hz;  ///< of the normal modes, where they were computed
};

/// Proper orthogonal modes of the files' samples, which are read block by block and never held. `control.progress` is told the
/// samples read (of 0, as nobody knows how many there are), `control.interrupted` asked at each block; `task.threads` counts, not
/// the control's. Throws InputError, and Interrupted.
PodResult run_pod(const PodTask& task, const ident::Control& control = {});

/// The same shared by the processes of a team, each of which reads its part of every file: the result in the first, none in the
/// others.
std::optional<PodResult> run_pod(const PodTask& task, ident::Team& team, const ident::Control& control = {});

/// The same of a record that was read, with the matrices that the task names. Throws InputError.
PodResult run_pod(const PodTask& task, PodRecord record);

}  // namespace jointid::tasks
