#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/plan_text.hpp"

namespace jointid::cli {

ExitCode execute(const PlanArguments& arguments, std::ostream& out) {
  check_targets(arguments.scene, {{"--json", arguments.json}});
  const auto plan = ident::make_plan(ident::read_scene(arguments.scene));
  if (arguments.json) write_target(*arguments.json, plan_json(*plan), out);
  if (arguments.json != "-") out << plan_text(*plan);
  return ExitCode::done;
}

}  // namespace jointid::cli
