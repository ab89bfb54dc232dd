#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "gui/solve/solve_job.hpp"

/// Runs are kept as files in a folder beside the scene, and read again with it.
namespace jointid::gui {

/// "rig1.runs" beside rig1.toml.
QString run_folder(const QString& scene_file);

/// Writes the run into the folder of the scene, which is made where it is missing, and notes in it by which name. Throws
/// InputError.
void keep_run(Solved& run, const QString& scene_file);

struct KeptRuns {
  std::vector<Solved> runs;  ///< without plans, in the order in which they were made
  QStringList failed;        ///< files that are no runs, with the reason
};

/// All runs in the folder of a scene. May be called by any thread.
KeptRuns read_kept_runs(const QString& scene_file);

/// Makes the plan of a run that was read, from its scene and the files as they are now. Throws InputError.
void make_plan_of(Solved& run);

}  // namespace jointid::gui
