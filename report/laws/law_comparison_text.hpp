#pragma once

#include <string>

#include "laws/task/law_comparison.hpp"
#include "report/text/table.hpp"

namespace jointid::report {

/// A row for each stiffness and limit: truth, bound, and of each way rms error, bias and answers; how many times larger errors
/// are.
Table law_ways_table(const laws::LawComparison& comparison);
/// What was compared, and the time that each way took, in lines.
std::string law_ways_summary(const laws::LawComparison& comparison);

/// A comparison of ways to find friction joints for people, as JSON, its values as CSV, and as a page.
std::string law_comparison_text(const laws::LawScene& scene, const laws::LawComparison& comparison);
std::string law_comparison_json(const laws::LawComparison& comparison);
std::string law_comparison_csv(const laws::LawComparison& comparison);
std::string law_comparison_page(const laws::LawScene& scene, const laws::LawComparison& comparison);

}  // namespace jointid::report
