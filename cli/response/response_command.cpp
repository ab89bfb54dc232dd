#include "cli/response/response_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/resume/kept_state.hpp"
#include "cli/text/failure.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "report/response/curve_rows.hpp"
#include "report/response/response_file.hpp"
#include "report/response/response_page.hpp"
#include "report/response/response_text.hpp"
#include "report/response/ways_text.hpp"
#include "scene/text.hpp"
#include "tasks/response/level_state.hpp"
#include "tasks/response/read_response_scene.hpp"
#include "tasks/response/response_result.hpp"
#include "tasks/response/response_scene.hpp"
#include "tasks/response/run_response.hpp"

namespace jointid::cli {
namespace {

constexpr const char* state_end = ".response.partial";

}  // namespace

void add_response(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ResponseArguments>(
      app, chosen, "response",
      "Find the periodic response of a structure with friction joints, from FRFs of its parts or from matrices");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [data] or [structure], [[joints]], [force], [response]")
      ->required();
  add_outputs(command, *arguments, "the responses, joints and peaks", "the harmonics of the responses",
              "FRFs at all force levels, harmonics, peaks, loops, curves and motions");
  command->add_option("--out", arguments->out, "Write the table of --csv as HDF5 to this file");
  command->add_option("--curves", arguments->curves,
                      "Write the peaks over the force and [[curves]] to a file: HDF5 by the name .h5, else CSV; - for stdout");
  command->add_option("--history", arguments->history,
                      "Write the motions of [transient] to a file: HDF5 by the name .h5, else CSV; - for stdout");
  add_resume(command, arguments->resume, "the force levels so far", state_end);
  command->add_flag("--compare", arguments->compare,
                    "Instead: errors of harmonic balance and Algorithms One and Two from the exact orbit, over run time");
  command->footer(
      "Examples:\n  jointid response rig.toml --csv response.csv --report response.html\n"
      "  jointid problem write beams-B b && jointid response b/beams-B.toml --compare");
}

namespace {

void check_outputs(const ResponseArguments& arguments, const tasks::ResponseScene& scene) {
  const auto refuse = [&](std::string place, std::string problem, std::string remedy) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = arguments.scene.string(),
                      .place = std::move(place),
                      .problem = std::move(problem),
                      .remedy = std::move(remedy)});
  };
  check_targets(tasks::files_of(scene), {{"--json", arguments.json},
                                         {"--csv", arguments.csv},
                                         {"--report", arguments.report},
                                         {"--curves", arguments.curves},
                                         {"--history", arguments.history},
                                         {"--out", arguments.out},
                                         {"--state", state_file(arguments.resume, arguments.scene, state_end).string()}});
  if (arguments.history && !scene.transient)
    refuse("--history", "the scene has no [transient]", "add one, or leave --history out");
  if (arguments.out && *arguments.out == "-") refuse("--out", "HDF5 does not go to standard output", "name a file");
  if (arguments.out && scene.levels.empty()) refuse("--out", "the scene has no [force]", "--history writes the motions");
  if (arguments.curves && scene.levels.empty()) refuse("--curves", "the scene has no [force]", "--history writes the motions");
  if (arguments.compare && (arguments.history || arguments.curves || arguments.out || arguments.report)) {
    refuse("--compare", "it writes --json and --csv alone", "leave the others out");
  }
  if (arguments.compare && arguments.resume.keeps_from_start())
    refuse("--compare", "it keeps no finished levels", "leave --resume, --stop-before and --state out");
}

/// The levels of a run: those of a run before, and a file for the next.
class LevelsKept {
 public:
  LevelsKept(const ResponseArguments& arguments, const tasks::ResponseScene& scene)
      : from_start_(arguments.resume.keeps_from_start()),
        all_(scene.levels.size()),
        state_(state_file(arguments.resume, arguments.scene, state_end), "response", scene::read_text(arguments.scene),
               tasks::files_of(scene)),
        is_over_(cli::is_over(arguments.resume)) {
    if (!arguments.resume.resume) return;
    const auto before = state_.read();
    if (!before) return;
    auto levels = tasks::unpacked_levels(*before);
    if (!levels || levels->finished.size() > all_) {
      throw InputError({.kind = ErrorKind::data,
                        .file = state_.file().string(),
                        .place = "--resume",
                        .problem = "is no state of these levels",
                        .remedy = "remove the file to start anew"});
    }
    before_ = std::move(*levels);
    so_far_.put(before_);
  }

  const tasks::LevelsSoFar& before() const { return before_; }

  /// Points of a level are copied at most once in a second, and where the run is to end.
  void keep(const std::vector<tasks::LevelResponse>& finished, const std::vector<response::HarmonicSolution>& begun) {
    if (!begun.empty() && !is_over_() && seconds_since(kept_) < 1.0) return;
    kept_ = Clock::now();
    if (finished.empty() && begun.empty()) return;
    so_far_.put({finished, begun});
    if (from_start_) state_.put(tasks::packed_levels({finished, begun}));
  }

  /// Of an interrupted run: keeps the levels where that was not done; what is reported of them.
  std::string words() {
    const auto levels = so_far_.get();
    if (!levels) return "interrupted";
    if (!from_start_) {
      if (const std::string why = state_.why_not_put(tasks::packed_levels(*levels)); !why.empty())
        return "interrupted; the finished force levels are not kept: " + why;
    }
    std::string text = fmt::format("interrupted; {} keeps {} of {} force levels", state_.file().string(), levels->finished.size(), all_);
    if (!levels->begun.empty()) text += fmt::format(" and {} points of the next", levels->begun.size());
    return text + ", the same command with --resume continues";
  }

  bool is_over() const { return is_over_(); }
  void remove() { state_.remove(); }

 private:
  bool from_start_;
  std::size_t all_;
  KeptState state_;
  std::function<bool()> is_over_;
  Clock::time_point kept_ = Clock::now();
  tasks::LevelsSoFar before_{};
  SoFar<tasks::LevelsSoFar> so_far_;
};

tasks::ResponseResult run_watched(const tasks::ResponseScene& scene, LevelsKept& kept) {
  Progress progress;
  ident::Control control = progress.control();
  control.interrupted = [&] { return kept.is_over(); };
  const tasks::KeepLevels keep = [&](const auto& finished, const auto& begun) { kept.keep(finished, begun); };
  return with_last_words([&] { return kept.words(); }, [&] { return tasks::run_response(scene, control, kept.before(), keep); });
}

void write_history(const std::string& target, const tasks::ResponseResult& run, std::ostream& out) {
  if (report::names_hdf5(target)) {
    report::write_history_table(target, run);
  } else {
    write_target(target, report::history_csv(run), out);
  }
}

void write_curves(const std::string& target, const tasks::ResponseResult& run, std::ostream& out) {
  if (report::names_hdf5(target)) {
    report::write_curves_table(target, run);
  } else {
    write_target(target, report::curves_csv(run), out);
  }
}

ExitCode compare(const ResponseArguments& arguments, const tasks::ResponseScene& scene, std::ostream& out) {
  const std::vector<tasks::WaysResult> runs = [&] {
    Progress progress;
    return tasks::compare_responses(scene, progress.control());
  }();
  if (arguments.json) write_target(*arguments.json, report::ways_json(scene, runs), out);
  if (arguments.csv) write_target(*arguments.csv, report::ways_csv(runs), out);
  if (!takes_output({arguments.json, arguments.csv})) out << report::ways_text(scene, runs);
  if (tasks::all_known(runs)) return ExitCode::done;
  print_error(arguments.scene.string() + ": no exact orbit was found");
  return ExitCode::unusable;
}

}  // namespace

ExitCode execute(const ResponseArguments& arguments, std::ostream& out) {
  check(arguments.resume);
  const tasks::ResponseScene scene = tasks::read_response_scene(arguments.scene);
  check_outputs(arguments, scene);
  if (arguments.compare) return compare(arguments, scene, out);
  LevelsKept kept(arguments, scene);
  const tasks::ResponseResult run = run_watched(scene, kept);
  if (arguments.json) write_target(*arguments.json, report::response_json(scene, run), out);
  if (arguments.csv) write_target(*arguments.csv, report::response_csv(run), out);
  if (arguments.report) write_target(*arguments.report, report::response_report(scene, run), out);
  if (arguments.curves) write_curves(*arguments.curves, run, out);
  if (arguments.history) write_history(*arguments.history, run, out);
  if (arguments.out) report::write_response_table(*arguments.out, run);
  if (!takes_output({arguments.json, arguments.csv, arguments.report, arguments.curves, arguments.history}))
    out << report::response_text(scene, run);
  kept.remove();
  if (tasks::all_converged(run)) return ExitCode::done;
  print_error(arguments.scene.string() + ": harmonic balance did not converge everywhere");
  return ExitCode::unusable;
}

}  // namespace jointid::cli
