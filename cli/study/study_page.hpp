#pragma once

#include <string>

#include "cli/study/study_text.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::cli {

/// The page of a finished study of a scene. Reads the study's result file in pieces.
std::string study_report(const StudyReport& report, const ident::Scene& scene);

}  // namespace jointid::cli
