#pragma once

#include <string>
#include <vector>

#include "friction/curve/curve.hpp"
#include "tasks/loading_curve/loading_curve_task.hpp"

namespace jointid::tasks {

/// The curves of the files as they are fitted, SI units, and what was done to get them.
struct LoadingCurveData {
  std::vector<friction::Curve> curves;  ///< one per file; of records with cycles, one per loop
  bool loops = false;
  std::vector<std::string> notes;  ///< "rig.txt: 49 loops", "rig.txt: forces times -1, …"
};

/// Reads the files: columns, units, integration of velocities, direction, elastic deformation of the specimen, cycles cut and
/// centred. Throws InputError (data, or usage for options that the file contradicts).
LoadingCurveData read_curves(const LoadingCurveTask& task);

}  // namespace jointid::tasks
