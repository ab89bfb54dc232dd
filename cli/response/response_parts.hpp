#pragma once

#include "report/response/curve_rows.hpp"
#include "report/response/prepared.hpp"
#include "report/response/read_response_scene.hpp"
#include "report/response/response_file.hpp"
#include "report/response/response_page.hpp"
#include "report/response/response_tables.hpp"
#include "report/response/response_text.hpp"
#include "report/response/run_response.hpp"

/// Responses are computed and told by what report/ has.
namespace jointid::cli {

using jointid::report::all_converged;
using jointid::report::coordinates;
using jointid::report::CurveRun;
using jointid::report::curves_csv;
using jointid::report::files_of;
using jointid::report::history_csv;
using jointid::report::joints_of;
using jointid::report::LevelResponse;
using jointid::report::marches;
using jointid::report::most_full;
using jointid::report::names_hdf5;
using jointid::report::parse_response_scene;
using jointid::report::peaks_table;
using jointid::report::points_table;
using jointid::report::prepare;
using jointid::report::Prepared;
using jointid::report::read_response_scene;
using jointid::report::response_csv;
using jointid::report::response_json;
using jointid::report::response_remarks;
using jointid::report::response_report;
using jointid::report::response_text;
using jointid::report::ResponseRun;
using jointid::report::ResponseScene;
using jointid::report::run_response;
using jointid::report::write_curves_table;
using jointid::report::write_history_table;
using jointid::report::write_response_table;

}  // namespace jointid::cli
