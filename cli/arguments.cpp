#include "cli/arguments.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

#include "cli/command_options.hpp"
#include "cli/couple_arguments.hpp"
#include "cli/equivalent_arguments.hpp"
#include "cli/modalfit_arguments.hpp"
#include "cli/of_option.hpp"
#include "cli/open_options.hpp"
#include "cli/stability_arguments.hpp"
#include "cli/usage_error.hpp"
#include "cli/version.hpp"
#include "cli/whole_number.hpp"
#include "base/error.hpp"

namespace jointid::cli {
namespace {

using Chosen = std::optional<Arguments>;

void add_info(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<InfoArguments>(app, chosen, "info", "Say what an FRF file holds");
  command->add_option("FILE", arguments->file, "UFF, HDF5, MAT or CSV")->required();
  add_open_options(command, arguments->open);
  command->footer("Example:\n  jointid info beam_long.uff");
}

void add_convert(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<ConvertArguments>(
      app, chosen, "convert", "Convert FRF files, several of one structure into one; the name of OUT gives the format");
  command
      ->add_option_function<std::vector<std::filesystem::path>>(
          "IN OUT",
          [to = arguments](const std::vector<std::filesystem::path>& files) {
            if (files.size() < 2) throw CLI::RequiredError("OUT");
            to->in = {files.begin(), files.end() - 1};
            to->out = files.back();
          },
          "Files to read: UFF, HDF5, MAT, CSV or text exports of an analyser; last the file to write")
      ->required();
  add_open_options(command, arguments->open);
  command->footer(
      "Examples:\n  jointid convert beam_long.uff beam_long.h5\n"
      "  jointid convert rig.mat rig.h5 --quantity accelerance --response 4:+Y,5:+Y\n"
      "  jointid convert hit_1.txt hit_3.txt beam.h5 --response 4:-X --reference 1:+X,3:+X");
}

void add_problem(CLI::App& app, Chosen& chosen) {
  CLI::App* problem = app.add_subcommand("problem", "Built-in problems with known answers");
  problem->require_subcommand(1);
  problem->footer("Examples:\n  jointid problem list\n  jointid problem write A1 a1 --format uff");

  auto [list, none] = add_command<ProblemListArguments>(*problem, chosen, "list", "List them");
  list->footer("Example:\n  jointid problem list");

  auto [write, arguments] = add_command<ProblemWriteArguments>(*problem, chosen, "write",
                                                               "Write FRF files, scene and truth of a problem");
  write->add_option("NAME", arguments->name, "As in `jointid problem list`")->required();
  write->add_option("DIR", arguments->directory, "Made if absent")->required();
  write->add_option("--format", arguments->options.format, "Format of the FRF files")
      ->check(CLI::IsMember({"h5", "uff"}))
      ->capture_default_str();
  add_whole_number(write, "--seed", arguments->options.seed, "Of the noise", {});
  write->add_flag("--clean", arguments->options.clean, "Leave the noise out");
  write->footer("Example:\n  jointid problem write A1 a1 --seed 7");
}

void add_solve(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<SolveArguments>(app, chosen, "solve", "Identify the joint of a scene");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  add_outputs(command, *arguments, "the solution", "the unknowns", "tables and plots");
  command->add_option("--plot", arguments->plot, "Plot an assembly FRF, measured and regenerated, e.g. 1:+Y/5:+Y");
  command->footer(
      "Examples:\n  jointid solve joint.toml\n  jointid solve joint.toml --plot 1:+Y/5:+Y\n  jointid solve joint.toml --json - | "
      "jq .unknowns\n"
      "  jointid solve joint.toml --report joint.html");
}

void add_plan(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<PlanArguments>(
      app, chosen, "plan", "Say what solving a scene reads, computes and leaves out, without doing it");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  command->add_option("--json", arguments->json, "Write the plan as JSON to a file, or - for stdout");
  CLI::Option* bound = command->add_flag("--bound", arguments->bound,
                                         "Predict standard errors from the FRFs of a model or an earlier test, the noise and "
                                         "[truth] or [identify] start, and what other data would change");
  command
      ->add_option_function<std::vector<std::string>>(
          "--candidates",
          [arguments = arguments](const std::vector<std::string>& texts) {
            arguments->candidates = of_option("--candidates", [&] { return parse_dofs(texts); });
          },
          "Coordinates of the files that are not measured yet, e.g. 3:+Y,4:+RZ: what would each of them bring?")
      ->delimiter(',')
      ->needs(bound);
  command->footer(
      "Examples:\n  jointid plan joint.toml\n  jointid plan joint.toml --bound\n"
      "  jointid plan joint.toml --bound --candidates 3:+Y,4:+RZ");
}

void add_check(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CheckArguments>(
      app, chosen, "check", "Look for mistakes in the FRFs of a scene: signs, labels, units, axes, loose joints");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML)")->required();
  command->add_option("--json", arguments->json, "Write verdict and suspects as JSON to a file, or - for stdout");
  command->footer("Examples:\n  jointid check joint.toml\n  jointid check joint.toml --json - | jq .suspects");
}

/// --trials, --seed and --threads of commands that draw noise.
template <class T>
void add_trial_options(CLI::App* command, T& arguments) {
  add_whole_number(command, "--trials", arguments.trials, "How often", counts_of_trials());
  add_whole_number(command, "--seed", arguments.seed, "Of the noise", {});
  add_whole_number(command, "--threads", arguments.threads, "0 for all cores; the results do not depend on it", counts_of_threads());
}

void add_study(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<StudyArguments>(
      app, chosen, "study", "Identify over and over with simulated noise, to see how well the rig sees the joint");
  command->add_option("SCENE", arguments->scene, "Scene file (TOML) on noise-free or measured FRFs, with [noise]")->required();
  add_trial_options(command, *arguments);
  command->add_flag("--resume", arguments->resume, "Continue an interrupted study");
  command->add_option("--out", arguments->out, "All results (HDF5); default: SCENE's name with .study.h5, here");
  add_outputs(command, *arguments, "the statistics", "the unknowns' statistics", "tables and histograms");
  command->footer(
      "Examples:\n  jointid problem write A1 a1 --clean && jointid study a1/A1.toml --trials 10000\n"
      "  jointid study a1/A1.toml --trials 10000 --report a1.html\n"
      "  mpirun -n 4 jointid study a1/A1.toml --trials 1000000 --threads 1");
}

void add_compare(CLI::App& app, Chosen& chosen) {
  auto [command, arguments] = add_command<CompareArguments>(
      app, chosen, "compare", "Compare ways of identifying by error and run time, on the same trials with simulated noise");
  CLI::Option* scene = command->add_option("SCENE", arguments->scene, "Scene file (TOML) with [truth] and [noise]");
  const auto list = [command = command](const char* name, auto& to, const char* what) {
    return command->add_option(name, to, what)->delimiter(',');
  };
  const std::vector<CLI::Option*> alternatives = {
      list("--methods", arguments->methods, "one,two; default of each list: the scene's"),
      command->add_option("--equations", arguments->equations, "Sets of equations, e.g. \"nn nj;nn nj jj jn\""),
      list("--weightings", arguments->weightings, "none,WA,WB,WBG,WBS"),
      list("--deltas", arguments->deltas, "0,0.05,0.1"),
      list("--solvers", arguments->solvers, "qr,normal,spqr"),
      list("--regenerate", arguments->regenerate,
           "FRFs replaced by those of modal models: none,substructures,assembly,substructures+assembly")};
  CLI::Option* reproduce = command->add_option("--reproduce", arguments->reproduce,
                                               "Instead of a scene: a table of Ren's thesis beside ours, e.g. 6.3; or list");
  reproduce->excludes(scene);
  for (CLI::Option* option : alternatives) reproduce->excludes(option);
  add_trial_options(command, *arguments);
  add_outputs(command, *arguments, "the figures", "the figures", "tables and plots");
  command->footer(
      "Examples:\n  jointid problem write B b --clean && jointid compare b/B.toml --weightings WA,WBS --deltas 0,0.05,0.1\n"
      "  jointid compare --reproduce 6.9 --report table.html");
}

}  // namespace

std::variant<Arguments, Notice> parse(int argc, const char* const* argv) {
  CLI::App app("Finds the stiffness, mass and damping of joints from measured frequency response functions.", "jointid");
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(
      "Examples:\n  jointid problem write A1 a1   write a built-in problem\n"
      "  jointid solve a1/A1.toml      identify its joint\n"
      "  jointid solve --help          help on one command");
  Chosen chosen;
  add_solve(app, chosen);
  add_plan(app, chosen);
  add_check(app, chosen);
  add_study(app, chosen);
  add_compare(app, chosen);
  auto [loading_curve, loading_curve_arguments] =
      add_command<LoadingCurveArguments>(app, chosen, "loading-curve", "Find the law of a friction joint from measured curves");
  declare(*loading_curve, *loading_curve_arguments);
  add_couple(app, chosen);
  add_equivalent(app, chosen);
  add_modalfit(app, chosen);
  auto [stability, stability_arguments] = add_command<StabilityArguments>(
      app, chosen, "stability", "Measure how many digits every solver keeps on extreme cases, against 50-digit arithmetic");
  declare(*stability, *stability_arguments);
  add_info(app, chosen);
  add_convert(app, chosen);
  add_problem(app, chosen);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    std::ostringstream out, err;
    app.exit(success, out, err);
    return Notice{ExitCode::done, out.str()};
  } catch (const CLI::ParseError& error) {
    return Notice{ExitCode::usage, usage_error(app, error)};
  }
  return *chosen;
}

}  // namespace jointid::cli
