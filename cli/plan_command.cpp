#include "cli/bound_text.hpp"
#include "cli/commands.hpp"
#include "cli/output.hpp"
#include "cli/plan_text.hpp"
#include "cli/progress.hpp"
#include "ident/check/check.hpp"
#include "ident/judgement/judge.hpp"

namespace jointid::cli {
namespace {

void note_suspect(ident::Plan& plan, const ident::Control& control) {
  const ident::CheckResult found = ident::quick_check(plan, control);
  if (found.verdict != ident::Verdict::clean) plan.notes.push_back(ident::phrase(found.suspects.front()));
}

}  // namespace

ExitCode execute(const PlanArguments& arguments, std::ostream& out) {
  const ident::Scene scene = ident::read_scene(arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}});
  const auto plan = with_progress("planning", [&] { return ident::make_plan(scene); });
  std::optional<ident::BoundReport> bound;
  if (arguments.bound) {
    Progress progress;
    bound = ident::predict_bound(*plan, arguments.candidates, progress.control());
    if (!bound->interrupted) note_suspect(*plan, progress.control());
  }
  const bool cut = bound && bound->interrupted;
  if (arguments.json) write_target(*arguments.json, plan_json(*plan, bound), out);
  if (arguments.json != "-") out << plan_text(*plan) << (bound ? bound_text(*bound) : "");
  if (cut) throw Interrupted("interrupted; what was predicted so far is written");
  return ExitCode::done;
}

}  // namespace jointid::cli
