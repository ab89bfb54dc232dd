#pragma once

#include "frf/set/frf_set.hpp"
#include "tasks/response/response_result.hpp"

namespace jointid::tasks {

/// Reads the files that the scene names and finds what it asks for: for each force level the periodic responses over frequency by
/// harmonic balance, their peaks, modes, loops, errors and stability; then curves, equivalent joints and motions from rest.
/// `control.progress` is told the stage ("2 N", "curve 1") and points done of all, `control.interrupted` asked between points;
/// other members are not used. What does not converge is marked in the result (all_converged()). Throws InputError (usage, data),
/// and Interrupted.
ResponseResult run_response(const ResponseScene& scene, const ident::Control& control = {});

/// The same with FRFs of the parts in memory in place of the scene's files. Throws InputError for sets whose sizes do not agree,
/// too.
ResponseResult run_response(const ResponseScene& scene, std::vector<frf::FrfSet> parts, const ident::Control& control = {});

}  // namespace jointid::tasks
