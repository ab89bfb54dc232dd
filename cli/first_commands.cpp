#include "cli/check/check_command.hpp"
#include "cli/commands.hpp"
#include "cli/convert/convert_command.hpp"
#include "cli/convert/info_command.hpp"
#include "cli/options/complete_program.hpp"
#include "cli/problem/problem_command.hpp"
#include "cli/solve/plan_command.hpp"
#include "cli/solve/solve_command.hpp"

namespace jointid::cli {
namespace {

void add_first_commands(CLI::App& app, Chosen& chosen) {
  add_linear_solve(app, chosen);
  add_linear_plan(app, chosen);
  add_linear_check(app, chosen);
  add_info(app, chosen);
  add_convert(app, chosen);
  declare_problem(app, chosen, linear_problems());
}

}  // namespace

std::variant<ChosenCommand, Notice> parse_first(int argc, const char* const* argv) {
  auto parsed = parse(argc, argv, add_first_commands);
  if (auto* notice = std::get_if<Notice>(&parsed)) {
    if (notice->is_version) return parsed;
    go_on_complete(argv);  // help and what is wrong with a command line are better said by who knows all commands
    const std::string more = std::string("for more commands, ") + how_to_complete;
    notice->text += notice->code == ExitCode::done ? more + "\n" : "; " + more;
  } else if (const auto& chosen = std::get<ChosenCommand>(parsed); chosen.is_elsewhere && chosen.is_elsewhere()) {
    go_on_complete(argv);
  }
  return parsed;
}

}  // namespace jointid::cli
