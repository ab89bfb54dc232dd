#include "cli/commands.hpp"
#include "cli/couple_json.hpp"
#include "cli/couple_text.hpp"
#include "cli/failure.hpp"
#include "cli/interrupt.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/report/couple_report.hpp"
#include "frf/error.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path result_path(const CoupleArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::filesystem::path path = arguments.scene.filename();
  path.replace_extension(".coupled.h5");
  return path;
}

/// A part must not be overwritten while it is read.
void require_other_files(const ident::CoupleScene& scene, const std::filesystem::path& out, bool bounds) {
  for (const ident::DataFile& part : scene.parts) {
    for (const auto& file : {out, bounds ? ident::with_all_path(out) : out}) {
      std::error_code ignored;
      if (!std::filesystem::equivalent(part.path, file, ignored)) continue;
      throw InputError({ErrorKind::usage, file.string(), "--out", "it is a part of the scene", "name another file"});
    }
  }
}

}  // namespace

ExitCode execute(const CoupleArguments& arguments, std::ostream& out) {
  const std::filesystem::path path = result_path(arguments);
  check_targets(arguments.scene, {{"--out", path.string()}, {"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}});
  const ident::CoupleScene scene = ident::read_couple_scene(arguments.scene);
  require_other_files(scene, path, arguments.bounds);
  catch_interrupts();
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
