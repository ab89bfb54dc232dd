#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frf/csv/csv_parts.hpp"

namespace jointid::frf {

/// "m/s2" of m, s2 and of m, s, 2; "g/N" of g, per, N. Empty where the words are no ratio.
std::string ratio_of_words(const std::vector<std::string_view>& words);

/// Takes the unit of an FRF out of a title whose words underscores part, "H11_g_N_re", "Re_H11_m_per_s2_N", where it states none.
void take_ratio(CsvTitle& title);

}  // namespace jointid::frf
