#pragma once

#include <memory>
#include <vector>

#include "ident/check/check.hpp"
#include "ident/plan/plan.hpp"
#include "study/trial_data.hpp"
#include "problems/case/identification_problem.hpp"

namespace jointid::problems {

/// The scene of a problem as read from its text.
ident::Scene scene(const Problem& problem);

/// A plan on FRFs in memory: the scene's files are not opened.
std::unique_ptr<ident::Plan> plan(const ident::Scene& scene, Measurement measurement);

/// The FRFs of a set without those at some coordinates.
frf::FrfSet without(const frf::FrfSet& set, const std::vector<frf::Dof>& coordinates);

/// What a check says of FRFs in memory.
ident::CheckResult check(const ident::Scene& scene, Measurement measurement);

/// Base data and noise of the problem for trials: trial t of a seed has the FRFs of polluted(problem, seed, t). `scene` may
/// differ from the problem's own in what it identifies and how.
std::shared_ptr<const study::TrialData> trial_data(const ident::Scene& scene, const Problem& problem);

}  // namespace jointid::problems
