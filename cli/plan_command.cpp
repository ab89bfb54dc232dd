#include "cli/bound_text.hpp"
#include "cli/commands.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/plan_text.hpp"
#include "cli/progress.hpp"

namespace jointid::cli {

ExitCode execute(const PlanArguments& arguments, std::ostream& out) {
  check_targets(arguments.scene, {{"--json", arguments.json}});
  const auto plan = ident::make_plan(ident::read_scene(arguments.scene));
  std::optional<ident::BoundReport> bound;
  catch_interrupts();
  if (arguments.bound) {
    Progress progress;
    bound = ident::predict_bound(*plan, arguments.candidates, progress.control());
  }
  if (arguments.json) write_target(*arguments.json, plan_json(*plan, bound), out);
  if (arguments.json != "-") out << plan_text(*plan) << (bound ? bound_text(*bound) : "");
  return ExitCode::done;
}

}  // namespace jointid::cli
