#include "cli/check/check_command.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "report/result/check_text.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/text/progress.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "report/check_json.hpp"
#include "report/json_value.hpp"
#include "scene/text.hpp"

namespace jointid::cli {

CheckArguments& add_linear_check(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CheckArguments>(
      app, chosen, "check", "Find errors in the FRFs of a scene: signs, labels, units, time delays, mass loading, loose joints");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  command->add_option("--json", arguments->json, "Write verdict and suspects as JSON to a file, or - for stdout");
  add_force(command);
  command->footer("Examples:\n  jointid check joint.toml\n  jointid check joint.toml --json - | jq .suspects");
  return *arguments;
}

bool is_elsewhere(const CheckArguments& arguments) { return arguments.run_laws == nullptr && needs_laws(arguments.scene); }

void write_check(const CheckArguments& arguments, const ident::CheckResult& result, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, report::json_text(report::check_json(result)), out);
  if (!takes_output({arguments.json})) out << report::check_text(result);
}

ExitCode execute(const CheckArguments& arguments, std::ostream& out) {
  const std::string text = scene::read_text(arguments.scene);
  if (is_law_or_line_scene(text, arguments.scene)) return run_law_scene(arguments, text, out);
  const ident::Scene scene = ident::parse_scene(text, arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}});
  Progress progress;
  write_check(arguments, ident::check_whole(scene, progress.control()), out);
  return ExitCode::done;
}

}  // namespace jointid::cli
