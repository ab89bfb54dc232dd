#pragma once

#include "report/couple/couple_frfs.hpp"
#include "report/couple/couple_plots.hpp"
#include "report/couple/couple_text.hpp"

/// What a coupling shows, which report/ has.
namespace jointid::cli {

using jointid::report::alpha_plots;
using jointid::report::condition_plots;
using jointid::report::conditions_table;
using jointid::report::couple_csv;
using jointid::report::couple_text;
using jointid::report::coupling_method_text;
using jointid::report::kept_counts;
using jointid::report::kept_rule;
using jointid::report::predicted_plots;
using jointid::report::PredictedFrf;
using jointid::report::read_predicted;
using jointid::report::worst_line;

}  // namespace jointid::cli
