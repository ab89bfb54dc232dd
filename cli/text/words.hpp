#pragma once

#include "report/text/words.hpp"

namespace jointid::cli {

using jointid::report::chi_square_text;
using jointid::report::delta_text;
using jointid::report::dofs_text;
using jointid::report::equations_text;
using jointid::report::method_text;
using jointid::report::rounding_digits;
using jointid::report::weighting_text;
using jointid::report::words;

}  // namespace jointid::cli
