#include "cli/study/study_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <optional>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/output.hpp"
#include "cli/study/study_page.hpp"
#include "cli/study/study_text.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "laws/task/trial_file.hpp"
#include "report/laws/law_study_page.hpp"
#include "report/laws/law_study_text.hpp"
#include "report/result/study_tables.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"
#include "study/study_options.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path result_file(const StudyArguments& arguments) {
  return arguments.out.empty() ? std::filesystem::path(arguments.scene.stem().string() + ".study.h5") : arguments.out;
}

void check(const StudyArguments& arguments) {
  if (arguments.trials == 0) throw InputError({ErrorKind::usage, "", "--trials", "it is 0", "give 1 or more"});
}

/// The journal of an interrupted study is written, too.
void check_outputs(const StudyArguments& arguments, const ident::Scene& scene) {
  const std::string result = result_file(arguments).string();
  check_targets(ident::files_of(scene), {{"--json", arguments.json},
                                         {"--csv", arguments.csv},
                                         {"--report", arguments.report},
                                         {"--out", result},
                                         {"--out (while it runs)", study::journal_path(result).string()}});
}

std::size_t threads_of(const StudyArguments& arguments) {
  return threads_or_cores(arguments.threads, ident::processes_started());
}

study::StudyOptions options_of(const StudyArguments& arguments, const std::string& scene_text) {
  study::StudyOptions options;
  options.trials = arguments.trials;
  options.seed = arguments.seed;
  options.threads = threads_of(arguments);
  options.resume = arguments.resume;
  options.out = result_file(arguments);
  options.texts = report::study_texts(scene_text);
  return options;
}

/// "trial 1200 of 10000, 3480 per second, 2.5 s left".
class StudyProgress {
 public:
  void show(std::size_t done, std::size_t total) {
    const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    if (!first_) first_ = done;
    const double rate = static_cast<double>(done - *first_) / seconds;
    std::string text = fmt::format("trial {} of {}", done, total);
    if (rate > 0.0) text += fmt::format(", {:.3g} per second, {:.3g} s left", rate, static_cast<double>(total - done) / rate);
    progress_.show(text);
  }

 private:
  using Clock = std::chrono::steady_clock;
  Progress progress_;
  Clock::time_point start_ = Clock::now();
  std::optional<std::size_t> first_;
};

/// What a study needs to run.
struct Start {
  std::optional<laws::LawScene> laws;  ///< one of friction joints; then nothing else is there
  study::StudyOptions options;
  std::shared_ptr<const study::TrialData> data;
};

/// The same in every process of the team; a failure is told once.
Start start_in(ident::Team& team, const StudyArguments& arguments) {
  Start start;
  ident::start_together(team, [&] {
    check(arguments);
    const std::string text = scene::read_text(arguments.scene);
    if (scene::is_law_scene(text, arguments.scene)) {
      start.laws = laws::parse_law_scene(text, arguments.scene);
      return;
    }
    start.options = options_of(arguments, text);
    const ident::Scene scene = ident::parse_scene(text, arguments.scene);
    check_outputs(arguments, scene);
    start.data = with_progress("reading", [&] { return study::load_trial_data(scene); });
  });
  return start;
}

std::string to_go_on(const study::StudyOptions& options, std::size_t done) {
  if (!std::filesystem::exists(study::journal_path(options.out))) return "interrupted";
  return fmt::format("interrupted; {} keeps {} of {} trials, the same command with --resume continues",
                     study::journal_path(options.out).string(), done, options.trials);
}

/// Trials that take longer than an interrupted process has are dropped; what was done before is in the journal.
study::StudyRun run_watched(const Start& start, ident::Team& team) {
  StudyProgress progress;
  std::atomic<std::size_t> trials_done = 0;
  const LastWords words([&] { return to_go_on(start.options, trials_done); });
  study::StudyControl control{.progress = {}, .interrupted = interrupted, .row = {}};
  if (team.rank() == 0) {
    control.progress = [&](std::size_t done, std::size_t total) {
      trials_done = done;
      progress.show(done, total);
    };
  }
  return study::run_study(start.data, start.options, team, control);
}

/// The trials of a study of laws: text, as few numbers as they are.
std::filesystem::path law_trials_file(const StudyArguments& arguments) {
  return arguments.out.empty() ? std::filesystem::path(arguments.scene.stem().string() + ".study.csv") : arguments.out;
}

/// The leader writes; the others make their part of the trials.
ExitCode study_law_scene(const StudyArguments& arguments, const laws::LawScene& scene, ident::Team& team, std::ostream& out) {
  const std::filesystem::path path = law_trials_file(arguments);
  laws::LawStudyOptions options = {
      .trials = arguments.trials, .seed = arguments.seed, .threads = threads_of(arguments), .interrupted = interrupted};
  laws::AssumedStates assumed;
  std::optional<laws::TrialFile> file;
  ident::start_together(team, [&] {
    const bool leads = team.rank() == 0;
    if (leads) {
      check_targets(
          laws::files_of(scene),
          {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}, {"--out", path.string()}});
    }
    assumed = laws::assumed_states(scene);
    if (leads) {
      const std::string text = scene::read_text(arguments.scene);
      file.emplace(path, laws::TrialFileKey{text, arguments.seed, laws::law_study_plan(scene, assumed)}, arguments.resume);
    }
  });
  if (!file) {
    laws::study_laws_together(scene, assumed, options, team);
    return ExitCode::done;
  }
  options.known = file->known();
  std::atomic<std::size_t> done = 0;
  StudyProgress progress;
  options.made = [&](const laws::LawTrial& trial) { file->add(trial); };
  options.progress = [&](std::size_t so_far, std::size_t total) {
    done = so_far;
    progress.show(so_far, total);
  };
  const auto to_resume = [&] {
    return fmt::format("interrupted; {} keeps {} of {} trials, the same command with --resume continues", path.string(),
                       std::max<std::size_t>(done, file->known().size()), arguments.trials);
  };
  const LastWords words(to_resume);
  const laws::LawStudy study = [&] {
    try {
      return *laws::study_laws_together(scene, assumed, options, team);
    } catch (const Interrupted&) {
      throw Interrupted(to_resume());
    }
  }();
  if (arguments.json) write_target(*arguments.json, report::law_study_json(study), out);
  if (arguments.csv) write_target(*arguments.csv, report::law_study_csv(study), out);
  if (arguments.report) write_target(*arguments.report, report::law_study_page(scene, study), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::law_study_text(scene, study);
  return study.usable > 0 ? ExitCode::done : ExitCode::unusable;
}

}  // namespace

void add_study(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<StudyArguments>(
      app, chosen, "study", "Identify over and over with simulated noise, to see how well the rig sees the joint");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) on noise-free or measured FRFs, with [noise]")->required();
  add_trial_options(command, *arguments);
  command->add_flag("--resume", arguments->resume, "Continue an interrupted study");
  command->add_option("--out", arguments->out,
                      "All trials (HDF5; CSV of friction laws); default: SCENE's name with .study.h5 or .study.csv, here");
  add_outputs(command, *arguments, "the statistics", "the unknowns' statistics", "tables and histograms");
  command->footer(
      "Examples:\n  jointid problem write A1 a1 --clean && jointid study a1/A1.toml --trials 10000\n"
      "  jointid study a1/A1.toml --trials 10000 --report a1.html\n"
      "  mpirun -n 4 jointid study a1/A1.toml --trials 1000000 --threads 1");
}

ExitCode execute(const StudyArguments& arguments, std::ostream& out) {
  const auto team = ident::join_team();
  const Start start = start_in(*team, arguments);
  if (start.laws) return study_law_scene(arguments, *start.laws, *team, out);
  const study::StudyOptions& options = start.options;
  const study::StudyRun run = run_watched(start, *team);
  if (team->rank() != 0) return ExitCode::done;
  if (!run.complete) {
    throw Interrupted(to_go_on(options, run.done));
  }
  const StudyReport report{start.data->scene.title, options.out.string(), options.seed, run,
                           study::study_statistics(options.out), start.data->notes};
  if (arguments.json) write_target(*arguments.json, study_json(report), out);
  if (arguments.csv) write_target(*arguments.csv, study_csv(report), out);
  if (arguments.report) write_target(*arguments.report, study_report(report, start.data->scene), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << study_text(report);
  return report.statistics.usable > 0 ? ExitCode::done : ExitCode::unusable;
}

}  // namespace jointid::cli
