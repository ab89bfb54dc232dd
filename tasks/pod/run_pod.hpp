#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "ident/team/team.hpp"
#include "oscillation/pod/mode_comparison.hpp"
#include "oscillation/pod/pod.hpp"
#include "tasks/pod/pod_record.hpp"
#include "tasks/pod/pod_task.hpp"

namespace jointid::tasks {

/// Results of run_pod() for n channels.
struct PodResult {
  std::vector<std::string> names, units;  ///< of the channels
  std::size_t cut = 0;                    ///< samples of longer channels left out, of all channels together
  oscillation::Pod pod;                        ///< modes [n, n], values and means in the units of the channels
  bool weighted = false, mean_kept = false;
  std::string compared;                ///< "the modes of --compare", "the normal modes of --stiffness and --mass"; or empty
  Eigen::MatrixXd cosines, assurance;  ///< cosines and MAC, [modes, compared modes]; empty if there is no comparison
  std::vector<double> frequencies_hz;  ///< of the normal modes, where they were computed
  oscillation::ModeContributions contributions{};  ///< of the compared modes to each mode; empty if there is no comparison
};

/// Proper orthogonal modes of the files' samples, read block by block and not kept. `control.progress` gets the number of samples
/// read (of 0, as the total is unknown); `control.interrupted` is called at each block. The threads are `task.threads`, not the
/// control's. Throws InputError, and Interrupted.
PodResult run_pod(const PodTask& task, const ident::Control& control = {});

/// The same, shared by the processes of a team. Each reads its part of every file. The first has the result, the others have
/// none.
std::optional<PodResult> run_pod(const PodTask& task, ident::Team& team, const ident::Control& control = {});

/// The same for a record in memory, with the matrices of the task. Throws InputError.
PodResult run_pod(const PodTask& task, PodRecord record);

}  // namespace jointid::tasks
