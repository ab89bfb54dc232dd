#include "cli/commands.hpp"
#include "cli/equivalent_text.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"

namespace jointid::cli {

ExitCode execute(const EquivalentArguments& arguments, std::ostream& out) {
  const ident::EquivalentScene scene = ident::read_equivalent_scene(arguments.scene);
  check_targets(ident::files_of(scene), {{"--json", arguments.json}, {"--csv", arguments.csv}});
  const std::vector<ident::LevelJoint> levels = with_progress("reading and fitting", [&] { return ident::find_equivalent(scene); });
  if (arguments.json) write_target(*arguments.json, equivalent_json(scene, levels), out);
  if (arguments.csv) write_target(*arguments.csv, equivalent_csv(levels), out);
  if (!takes_output({arguments.json, arguments.csv})) out << equivalent_text(scene, levels);
  if (all_settled(levels)) return ExitCode::done;
  print_error(arguments.scene.string() + ": no stiffness and damping fit the FRFs of some levels");
  return ExitCode::unusable;
}

}  // namespace jointid::cli
