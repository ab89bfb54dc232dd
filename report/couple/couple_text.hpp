#pragma once

#include <string>

#include "report/text/table.hpp"
#include "tasks/couple.hpp"

namespace jointid::report {

/// What coupling did, for people.
std::string couple_text(const ident::CoupleScene& scene, const tasks::CoupleResult& result);

/// The same as JSON; the keys stay. Numbers that are not there are null.
std::string couple_json(const ident::CoupleScene& scene, const tasks::CoupleResult& result);

/// Line by line: frequency_hz, condition, kept, usable, the alpha of each condition of method mtc, and with a threshold on singular
/// values these and what each had to exceed.
std::string couple_csv(const tasks::CoupleResult& result);

/// The medians of the alphas, and who is left out.
Table conditions_table(const coupling::Dependencies& dependencies);

/// What the threshold keeps and why: "singular values above 0.01 of the largest"; empty without one.
std::string kept_rule(const ident::CoupleScene& scene);

/// "mtc, threshold alpha 0.3".
std::string coupling_method_text(const ident::CoupleScene& scene);

/// How many lines kept how many singular values (conditions), most first.
std::vector<std::pair<std::size_t, std::size_t>> kept_counts(const tasks::CoupleResult& result);

/// Index of the line with the largest condition number, or npos.
std::size_t worst_line(const tasks::CoupleResult& result);

}  // namespace jointid::report
