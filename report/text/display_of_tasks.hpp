#pragma once

#include <vector>

#include "report/text/display.hpp"
#include "tasks/couple/couple_frfs.hpp"
#include "tasks/equivalent.hpp"
#include "tasks/study/run_study.hpp"
#include "tasks/study/trial_histograms.hpp"

namespace jointid::report {

/// Unknowns of a study with all that is told of them.
tasks::StudyResult in_units_of(const Display& display, tasks::StudyResult result);

/// Histograms of unknowns; those of figures of merit stay.
tasks::StudyHistograms in_units_of(const Display& display, tasks::StudyHistograms histograms);

/// Displacements in mm, stiffness, damping and their deviation in N/mm.
std::vector<tasks::LevelJoint> in_units_of(const Display& display, std::vector<tasks::LevelJoint> levels);

/// Receptances of SI units with their variances as the quantity and the units that are shown.
std::vector<tasks::PredictedFrf> in_units_of(const Display& display, const std::vector<double>& frequency_hz,
                                             std::vector<tasks::PredictedFrf> frfs);

}  // namespace jointid::report
