#pragma once

#include <string>

#include "laws/task/law_study.hpp"

namespace jointid::cli {

/// A finished study of friction joints for people, as JSON, and its values as CSV.
std::string law_study_text(const laws::LawScene& scene, const laws::LawStudy& study);
std::string law_study_json(const laws::LawStudy& study);
std::string law_study_csv(const laws::LawStudy& study);

}  // namespace jointid::cli
