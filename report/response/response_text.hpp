#pragma once

#include <string>
#include <vector>

#include "tasks/response/response_result.hpp"

namespace jointid::report {

/// Peaks by level, or where there are few points all of them, curves, equivalent joints, transients and what is to be said of
/// them.
std::string response_text(const tasks::ResponseScene& scene, const tasks::ResponseResult& run);

/// What is to be said of the numbers, one sentence each: what is left out, unstable, not found, doubtful.
std::vector<std::string> response_remarks(const tasks::ResponseScene& scene, const tasks::ResponseResult& run);

/// Everything: harmonics of responses and joints, losses, what was dropped. The keys stay; numbers that are not there are null.
std::string response_json(const tasks::ResponseScene& scene, const tasks::ResponseResult& run);

/// A line for each level, frequency, harmonic and response: "force [N],frequency [Hz],harmonic,dof,re [m],im [m],std dev re
/// [m],std dev im [m],left out [m]": deviations are empty where nothing is known of errors, the last is the error bar of
/// harmonics beyond the lines of the files; points that did not converge are not there.
std::string response_csv(const tasks::ResponseResult& run);

/// Transients, a line for each time: "motion,time [s],x(DOF) [m] …,q(JOINT) [m],f(JOINT) [N] …".
std::string history_csv(const tasks::ResponseResult& run);

}  // namespace jointid::report
