#pragma once

#include "cli/text/table.hpp"
#include "report/laws/law_page.hpp"
#include "report/laws/law_text.hpp"

/// Laws are told by what report/ has.
namespace jointid::cli {

using jointid::report::joint_table;
using jointid::report::law_csv;
using jointid::report::law_json;
using jointid::report::law_page;
using jointid::report::law_text;

}  // namespace jointid::cli
