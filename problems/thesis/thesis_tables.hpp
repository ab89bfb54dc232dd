#pragma once

#include <string>
#include <vector>

#include "problems/thesis/thesis_table.hpp"

namespace jointid::problems {

/// The tables that can be computed anew, in the order of the thesis.
const std::vector<ThesisTable>& thesis_tables();

/// Throws InputError (usage) with the nearest number when there is none.
const ThesisTable& thesis_table(const std::string& number);

}  // namespace jointid::problems
