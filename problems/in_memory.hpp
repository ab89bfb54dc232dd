#pragma once

#include <memory>

#include "ident/plan.hpp"
#include "problems/problem.hpp"

namespace jointid::problems {

/// The scene of a problem as read from its text.
ident::Scene scene(const Problem& problem);

/// A plan on FRFs in memory: the scene's files are not opened.
std::unique_ptr<ident::Plan> plan(const ident::Scene& scene, Measurement measurement);

}  // namespace jointid::problems
