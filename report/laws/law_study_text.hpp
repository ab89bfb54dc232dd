#pragma once

#include <string>

#include "laws/task/law_study.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// A row for each number of the joints: truth, bound, errors, coverage.
Table law_values_table(const laws::LawStudy& study);
/// "200 trials, 198 usable; …": status, laws chosen, χ² over its freedom, in lines.
std::string law_study_summary(const laws::LawStudy& study);

/// A finished study of friction joints for people, as JSON, and its values as CSV.
std::string law_study_text(const laws::LawScene& scene, const laws::LawStudy& study);
std::string law_study_json(const laws::LawStudy& study);
std::string law_study_csv(const laws::LawStudy& study);

}  // namespace jointid::report
