#pragma once

#include <functional>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Reads the files of the scene and computes its results. For each force level these are the periodic responses over frequency by
/// harmonic balance, their peaks, modes, loops, errors and stability. Then follow curves, equivalent joints and motions from
/// rest. `control.progress` gets the stage ("2 N", "curve 1") and the points done of all; `control.interrupted` is called between
/// points. Other members are not used. Results that did not converge are marked (all_converged()). Throws InputError (usage,
/// data), and Interrupted. `before`: what `keep` got in a run that was interrupted; the result is that of one run, to the last bit.
ResponseResult run_response(const ResponseScene& scene, const ident::Control& control = {}, LevelsSoFar before = {},
                            const KeepLevels& keep = {});

/// The same with FRFs of the parts in memory in place of the scene's files. Throws InputError also for sets whose sizes do not
/// agree.
ResponseResult run_response(const ResponseScene& scene, std::vector<frf::FrfSet> parts, const ident::Control& control = {});

}  // namespace jointid::tasks
