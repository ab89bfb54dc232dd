#pragma once

#include <string>

#include "laws/task/law_bound.hpp"

namespace jointid::cli {

/// What `jointid plan --bound` says of a scene of friction joints, for people and as JSON.
std::string law_bound_text(const laws::LawScene& scene, const laws::LawBound& bound);
std::string law_bound_json(const laws::LawScene& scene, const laws::LawBound& bound);

}  // namespace jointid::cli
