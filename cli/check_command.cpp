#include <nlohmann/json.hpp>

#include "cli/check_json.hpp"
#include "cli/check_text.hpp"
#include "cli/commands.hpp"
#include "cli/json_value.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "ident/check/check.hpp"

namespace jointid::cli {

ExitCode execute(const CheckArguments& arguments, std::ostream& out) {
  const ident::Scene scene = ident::read_scene(arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}});
  Progress progress;
  const ident::CheckResult result = ident::check_scene(scene, progress.control());
  if (arguments.json) write_target(*arguments.json, json_text(check_json(result)), out);
  if (!takes_output({arguments.json})) out << check_text(result);
  return ExitCode::done;
}

}  // namespace jointid::cli
