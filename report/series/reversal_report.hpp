#pragma once

#include <string>
#include <vector>

#include "report/text/table.hpp"
#include "tasks/series/reversal.hpp"

namespace jointid::report {

std::vector<std::string> reversal_remarks(const tasks::ReversalResult& report);
Table reversal_table(const tasks::ReversalResult& report);

/// For people.
std::string reversal_text(const tasks::ReversalResult& report);
/// The keys stay.
std::string reversal_json(const tasks::ReversalResult& report);
/// The page of `jointid series reversal`.
std::string reversal_page(const tasks::ReversalResult& report);

}  // namespace jointid::report
