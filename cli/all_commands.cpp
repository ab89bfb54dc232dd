#include <array>

#include "cli/commands.hpp"
#include "cli/compare/compare_command.hpp"
#include "cli/convert/convert_command.hpp"
#include "cli/convert/info_command.hpp"
#include "cli/correlate/correlate_command.hpp"
#include "cli/couple/couple_command.hpp"
#include "cli/decouple/decouple_command.hpp"
#include "cli/equivalent/equivalent_command.hpp"
#include "cli/export/export_command.hpp"
#include "cli/frf/frf_command.hpp"
#include "cli/laws/law_commands.hpp"
#include "cli/loading_curve/loading_curve_command.hpp"
#include "cli/modalfit/modalfit_command.hpp"
#include "cli/oscillate/oscillate_command.hpp"
#include "cli/pod/pod_command.hpp"
#include "cli/problem/all_problems.hpp"
#include "cli/rerun/rerun_command.hpp"
#include "cli/response/response_command.hpp"
#include "cli/series/series_command.hpp"
#include "cli/stability/stability_command.hpp"
#include "cli/study/study_command.hpp"

namespace jointid::cli {
namespace {

/// The one place that names them all, in the order of the help.
constexpr std::array all_commands = {
    add_solve,  add_plan,     add_check,     add_study,  add_compare,    add_loading_curve, add_couple,
    add_decouple, add_correlate, add_expand, add_equivalent, add_response, add_modalfit, add_pod,
    add_oscillate, add_series, add_stability, add_frf,    add_info,       add_convert,       add_problem,
    add_export, add_rerun};

void add_commands(CLI::App& app, Chosen& chosen) {
  for (const auto& add : all_commands) add(app, chosen);
}

}  // namespace

std::variant<ChosenCommand, Notice> parse_all(int argc, const char* const* argv) { return parse(argc, argv, add_commands); }

}  // namespace jointid::cli
