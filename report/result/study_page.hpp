#pragma once

#include <string>

#include "ident/scene/scene.hpp"
#include "tasks/study/run_study.hpp"
#include "tasks/study/trial_histograms.hpp"

namespace jointid::report {

/// Unknowns that the page shows; the JSON and the result file have all.
inline constexpr std::size_t most_unknowns_shown = 300;

/// The page of a finished study of a scene. `histograms`: tasks::study_histograms() of as many unknowns as the page shows.
std::string study_page(const tasks::StudyResult& result, const ident::Scene& scene, const tasks::StudyHistograms& histograms);

}  // namespace jointid::report
