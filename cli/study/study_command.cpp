#include "cli/study/study_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <chrono>
#include <optional>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/display_options.hpp"
#include "cli/options/output.hpp"
#include "cli/provenance/provenance.hpp"
#include "cli/text/interrupt.hpp"
#include "cli/text/progress.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "report/laws/law_study_page.hpp"
#include "report/laws/law_study_text.hpp"
#include "report/result/study_page.hpp"
#include "report/result/study_text.hpp"
#include "report/text/display_of_tasks.hpp"
#include "scene/kind.hpp"
#include "scene/text.hpp"
#include "study/study_records.hpp"
#include "study/trial_data.hpp"
#include "tasks/study/run_law_study.hpp"

namespace jointid::cli {
namespace {

std::filesystem::path result_file(const StudyArguments& arguments) {
  if (!arguments.out.empty()) return arguments.out;
  std::string name = arguments.scene.empty() ? "merged" : arguments.scene.stem().string();
  if (!arguments.part.empty()) {
    const study::StudyPart part = study::parse_part(arguments.part);
    name += fmt::format(".part-{}-of-{}", part.number, part.count);
  }
  return name + ".study.h5";
}

/// The trials of a study of laws: text, as few numbers as they are.
std::filesystem::path law_trials_file(const StudyArguments& arguments) {
  return arguments.out.empty() ? std::filesystem::path(arguments.scene.stem().string() + ".study.csv") : arguments.out;
}

void check(const StudyArguments& arguments) {
  display_of(arguments.units);
  const auto refuse = [](const char* place, const std::string& problem, const char* remedy) {
    throw InputError({ErrorKind::usage, "", place, problem, remedy});
  };
  if (arguments.trials == 0) refuse("--trials", "it is 0", "give 1 or more");
  if (arguments.scene.empty() && arguments.merge.empty())
    refuse("SCENE", "it is missing", "give a scene file, or the files of all parts by --merge");
  if (arguments.stop_before && !(*arguments.stop_before > 0.0)) refuse("--stop-before", "it is not above 0", "give seconds");
  if (!arguments.part.empty() && study::parse_part(arguments.part).count > arguments.trials)
    refuse("--part", fmt::format("there are more parts than {} trials", arguments.trials), "give fewer parts");
  if (arguments.merge.empty()) return;
  if (!arguments.part.empty() || arguments.resume) refuse("--merge", "it runs no trials", "leave --part and --resume out");
  if (arguments.scene.empty() && arguments.report)
    refuse("--report", "the page shows the scene, which is missing", "give it: jointid study SCENE --merge PARTS --report FILE");
}

void check_outputs(const StudyArguments& arguments, const std::vector<ident::NamedFile>& inputs, const std::filesystem::path& trials) {
  check_targets(inputs, {{"--json", arguments.json}, {"--csv", arguments.csv}, {"--report", arguments.report}, {"--out", trials.string()}});
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
  if (!arguments.part.empty()) options.part = study::parse_part(arguments.part);
  options.seed = arguments.seed;
  options.threads = threads_of(arguments);
  options.resume = arguments.resume;
  options.out = result_file(arguments);
  options.texts = tasks::study_texts(scene_text);
  return options;
}

/// What the trials depend on, whatever part of them a run makes.
std::vector<std::string> command_of(const StudyArguments& arguments) {
  return {"jointid", "study",  arguments.scene.string(),         "--trials", std::to_string(arguments.trials),
          "--seed",  std::to_string(arguments.seed)};
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
  std::optional<laws::LawScene> laws;  ///< one of friction joints; then beside its text nothing else is there
  std::string text;
  study::StudyOptions options;
  std::shared_ptr<const study::TrialData> data;
};

void refuse_parts(const StudyArguments& arguments) {
  if (arguments.part.empty() && !arguments.stop_before) return;
  throw InputError({ErrorKind::usage, arguments.scene.string(), arguments.part.empty() ? "--stop-before" : "--part",
                    "studies of friction laws have no parts", "leave it out; --resume continues an interrupted study"});
}

/// The same in every process of the team; a failure is told once.
Start start_in(ident::Team& team, const StudyArguments& arguments) {
  Start start;
  ident::start_together(team, [&] {
    check(arguments);
    const std::string text = scene::read_text(arguments.scene);
    if (scene::is_law_scene(text, arguments.scene)) {
      refuse_parts(arguments);
      refuse_units(arguments.units);
      start.text = text;
      start.laws = laws::parse_law_scene(text, arguments.scene);
      if (team.rank() == 0) check_outputs(arguments, laws::files_of(*start.laws), law_trials_file(arguments));
      return;
    }
    start.options = options_of(arguments, text);
    const ident::Scene scene = ident::parse_scene(text, arguments.scene);
    check_outputs(arguments, scene);
    if (team.rank() == 0) start.options.texts["provenance"] = study_provenance(command_of(arguments));
    start.data = with_progress("reading", [&] { return study::load_trial_data(scene); });
  });
  return start;
}

std::string to_go_on(const study::StudyOptions& options, std::size_t done) {
  if (!std::filesystem::exists(study::journal_path(options.out))) return "interrupted";
  const auto [first, end] = study::trials_of(options.part, options.trials);
  return fmt::format("interrupted; {} keeps {} of {} trials, the same command with --resume continues",
                     study::journal_path(options.out).string(), done, end - first);
}

/// Trials that take longer than an interrupted process has are dropped; what was done before is in the journal.
tasks::StudyResult run_watched(const Start& start, ident::Team& team, std::optional<double> stop_before) {
  StudyProgress progress;
  std::atomic<std::size_t> trials_done = 0;
  const LastWords words([&] { return to_go_on(start.options, trials_done); });
  const auto is_over = [stop_before, begun = Clock::now()] {
    return interrupted() || (stop_before && seconds_since(begun) > *stop_before);
  };
  study::StudyControl control{.progress = {}, .interrupted = is_over, .row = {}};
  if (team.rank() == 0) {
    control.progress = [&](std::size_t done, std::size_t total) {
      trials_done = done;
      progress.show(done, total);
    };
  }
  return tasks::run_study(start.data, start.options, team, control);
}

/// What is told of a study of laws that is interrupted; before its trials began, no more than that.
class LawTrialsDone {
 public:
  LawTrialsDone(std::string file, std::size_t trials) : file_(std::move(file)), trials_(trials) {}

  void put(std::size_t done) {
    if (done > done_) done_ = done;
    begun_ = true;
  }
  std::string to_resume() const {
    if (!begun_) return "interrupted";
    return fmt::format("interrupted; {} keeps {} of {} trials, the same command with --resume continues", file_, done_.load(), trials_);
  }

 private:
  std::string file_;
  std::size_t trials_;
  std::atomic<std::size_t> done_ = 0;
  std::atomic<bool> begun_ = false;
};

std::optional<laws::LawStudy> run_laws_watched(const StudyArguments& arguments, const Start& start, ident::Team& team) {
  const tasks::LawTrialsFile trials{law_trials_file(arguments), start.text, arguments.resume};
  laws::LawStudyOptions options = {
      .trials = arguments.trials, .seed = arguments.seed, .threads = threads_of(arguments), .interrupted = interrupted};
  if (team.rank() > 0) return tasks::run_law_study(*start.laws, trials, options, team);
  LawTrialsDone done(trials.path.string(), arguments.trials);
  StudyProgress progress;
  options.progress = [&](std::size_t so_far, std::size_t total) {
    done.put(so_far);
    progress.show(so_far, total);
  };
  return with_last_words([&] { return done.to_resume(); }, [&] { return tasks::run_law_study(*start.laws, trials, options, team); });
}

/// The leader writes; the others make their part of the trials.
ExitCode study_law_scene(const StudyArguments& arguments, const Start& start, ident::Team& team, std::ostream& out) {
  const std::optional<laws::LawStudy> study = run_laws_watched(arguments, start, team);
  if (!study) return ExitCode::done;
  if (arguments.json) write_target(*arguments.json, report::law_study_json(*study), out);
  if (arguments.csv) write_target(*arguments.csv, report::law_study_csv(*study), out);
  if (arguments.report) write_target(*arguments.report, report::law_study_page(*start.laws, *study), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::law_study_text(*start.laws, *study);
  return study->usable > 0 ? ExitCode::done : ExitCode::unusable;
}

std::string page_of(const tasks::StudyResult& result, const ident::Scene& scene, const report::Display& display) {
  const auto histograms = tasks::study_histograms(result.file, result.statistics, report::most_unknowns_shown);
  return report::study_page(report::in_units_of(display, result), scene, report::in_units_of(display, histograms));
}

}  // namespace

void add_study(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<StudyArguments>(
      app, chosen, "study", "Monte-Carlo study: identify many times with simulated noise, for bias and scatter of every unknown");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) on noise-free or measured FRFs, with [noise]");
  add_trial_options(command, *arguments);
  command->add_flag("--resume", arguments->resume, "Continue an interrupted study");
  command->add_option("--part", arguments->part, "Run the trials of one part alone, e.g. 3/16 for the third of 16");
  command->add_option("--merge", arguments->merge, "Put the files of all parts together, in place of trials");
  command->add_option("--stop-before", arguments->stop_before, "Stop after so many seconds; --resume continues");
  command->add_option("--out", arguments->out,
                      "All trials (HDF5; CSV of friction laws); default: SCENE's name with .study.h5 or .study.csv, here");
  add_outputs(command, *arguments, "the statistics", "the unknowns' statistics", "tables and histograms");
  add_units(command, arguments->units);
  command->footer(
      "Examples:\n  jointid problem write A1 a1 --clean && jointid study a1/A1.toml --trials 10000\n"
      "  jointid study a1/A1.toml --trials 10000 --report a1.html\n"
      "  mpirun -n 4 jointid study a1/A1.toml --trials 1000000 --threads 1\n"
      "  jointid study a1/A1.toml --trials 10000 --part 3/16 --out part3.h5\n"
      "  jointid study --merge part*.h5 --out a1.h5");
}

namespace {

/// `scene`: for the page alone.
ExitCode write(const StudyArguments& arguments, const tasks::StudyResult& result, const ident::Scene& scene, std::ostream& out) {
  if (arguments.json) write_target(*arguments.json, report::study_json(result), out);
  const report::Display display = display_of(arguments.units);
  const tasks::StudyResult shown = report::in_units_of(display, result);
  if (arguments.csv) write_target(*arguments.csv, report::study_csv(shown), out);
  if (arguments.report) write_target(*arguments.report, page_of(result, scene, display), out);
  if (!takes_output({arguments.json, arguments.csv, arguments.report})) out << report::study_text(shown);
  return result.statistics.usable > 0 ? ExitCode::done : ExitCode::unusable;
}

ExitCode merge(const StudyArguments& arguments, std::ostream& out) {
  check(arguments);
  const std::filesystem::path file = result_file(arguments);
  std::vector<ident::NamedFile> inputs;
  for (const auto& part : arguments.merge) inputs.push_back({part, "--merge"});
  if (!arguments.scene.empty()) inputs.push_back({arguments.scene, "the scene"});
  check_outputs(arguments, inputs, file);
  const std::string text = arguments.scene.empty() ? std::string() : scene::read_text(arguments.scene);
  const ident::Scene scene = text.empty() ? ident::Scene() : ident::parse_scene(text, arguments.scene);
  return write(arguments, tasks::merge_study(arguments.merge, file, text), scene, out);
}

}  // namespace

ExitCode execute(const StudyArguments& arguments, std::ostream& out) {
  const auto team = ident::join_team();
  if (!arguments.merge.empty()) return team->rank() == 0 ? merge(arguments, out) : ExitCode::done;
  const Start start = start_in(*team, arguments);
  if (start.laws) return study_law_scene(arguments, start, *team, out);
  const tasks::StudyResult result = run_watched(start, *team, arguments.stop_before);
  if (team->rank() != 0) return ExitCode::done;
  if (!result.run.complete) throw Interrupted(to_go_on(start.options, result.run.done));
  return write(arguments, result, start.data->scene, out);
}

}  // namespace jointid::cli
