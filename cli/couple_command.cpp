#include "cli/commands.hpp"
#include "cli/couple_json.hpp"
#include "cli/couple_text.hpp"
#include "cli/failure.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report/couple_report.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path result_path(const CoupleArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::filesystem::path path = arguments.scene.filename();
  path.replace_extension(".coupled.h5");
  return path;
}

void check_outputs(const CoupleArguments& arguments, const ident::CoupleScene& scene, const std::filesystem::path& out) {
  std::vector<OptionTarget> targets = {
      {"--out", out.string()}, {"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}};
  if (arguments.bounds) targets.push_back({"--bounds", ident::with_all_path(out).string()});
  check_targets(ident::files_of(scene), targets);
}

}  // namespace

ExitCode execute(const CoupleArguments& arguments, std::ostream& out) {
  const std::filesystem::path path = result_path(arguments);
  const ident::CoupleScene scene = ident::read_couple_scene(arguments.scene);
  check_outputs(arguments, scene, path);
  Progress progress;
  ident::Control control = progress.control();
  control.threads = arguments.threads;
  const ident::CoupleResult result = ident::couple(scene, path, arguments.bounds, control);
  if (arguments.json) write_target(*arguments.json, couple_json(scene, result), out);
  if (arguments.csv) write_target(*arguments.csv, couple_csv(result), out);
  if (arguments.report) write_target(*arguments.report, report::couple_report(scene, result), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << couple_text(scene, result);
  if (result.status == ident::Status::ok) return ExitCode::done;
  print_error(arguments.scene.string() + ": " + result.message);
  return ExitCode::unusable;
}

}  // namespace jointid::cli
