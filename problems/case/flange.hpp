#pragma once

#include <string>
#include <vector>

#include "problems/case/identification_problem.hpp"
#include "problems/case/problem_info.hpp"

namespace jointid::problems {

/// Two frames with a rigid flange each, bolted together: a joint of six springs between the flanges' motions. Around each flange
/// 4 triaxial sensors and 18 impacts, from which the scene makes VP1 and VP2; two triaxial points further off on each part, hit
/// as well. 1 % noise.
std::vector<ProblemInfo> list_flanges();

bool is_flange(const std::string& name);

/// "flange", or "flange-turned", in whose test of part one the sensor 13:+Y was glued on turned: it points along (0, 0.6, 0.8).
Problem make_flange(const std::string& name);

}  // namespace jointid::problems
