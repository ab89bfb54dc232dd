#pragma once

#include <string>

#include "laws/task/law_bound.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// A row for each planned level: relative deviations of each joint's stiffness and limit with it or without it.
Table worth_table(const laws::LawScene& scene, const laws::LawBound& bound);

/// What `jointid plan --bound` says of a scene of friction joints, for people and as JSON.
std::string law_bound_text(const laws::LawScene& scene, const laws::LawBound& bound);
std::string law_bound_json(const laws::LawScene& scene, const laws::LawBound& bound);

}  // namespace jointid::report
