#pragma once

#include <string>

#include "laws/task/law_study.hpp"
#include "report/page/contents.hpp"

namespace jointid::report {

/// How often each number of a joint was found where, and its truth; empty where no trial tells one.
PlotGroup law_study_plots(const laws::LawStudy& study);

/// The page of `jointid study` of a scene of friction joints.
std::string law_study_page(const laws::LawScene& scene, const laws::LawStudy& study);

}  // namespace jointid::report
