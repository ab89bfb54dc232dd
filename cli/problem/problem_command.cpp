#include "cli/problem/problem_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/whole_number.hpp"
#include "ident/scene/method_traits.hpp"
#include "problems/case/coupling_problem.hpp"
#include "problems/case/flange.hpp"
#include "problems/case/modal_set.hpp"
#include "problems/case/rig_two.hpp"
#include "problems/problem.hpp"
#include "problems/thesis/loading_curves.hpp"
#include "problems/thesis/oscillations.hpp"
#include "problems/thesis/pulses.hpp"
#include "problems/thesis/two_beams.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {

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
  write->add_option("--method", arguments->options.method, "Of the scene, instead of that of the problem")
      ->check(CLI::IsMember(ident::method_words()));
  write->add_flag("--clean", arguments->options.clean, "Leave the noise out");
  write->footer("Example:\n  jointid problem write A1 a1 --seed 7");
}

ExitCode execute(const ProblemListArguments&, std::ostream& out) {
  report::Table table({{"name", report::Align::left}, {"what", report::Align::left}});
  for (const auto& problem : problems::list()) table.add({problem.name, problem.description});
  for (const auto& curve : problems::loading_curves()) table.add({curve.name, curve.description});
  for (const auto& problem : problems::list_flanges()) table.add({problem.name, problem.description});
  for (const auto& problem : problems::list_coupling()) table.add({problem.name, problem.description});
  for (const auto& rig : problems::list_rig_two()) table.add({rig.name, rig.description});
  for (const auto& set : problems::list_modal_sets()) table.add({set.name, set.description});
  for (const auto& beams : problems::list_two_beams()) table.add({beams.name, beams.description});
  for (const auto& pulse : problems::list_pulses()) table.add({pulse.name, pulse.description()});
  for (const auto& problem : problems::list_law_problems()) table.add({problem.name, problem.description});
  for (const auto& each : problems::list_oscillations()) table.add({each.name, each.description});
  out << table.text(0);
  return ExitCode::done;
}

namespace {

/// Throws InputError where files of that name are in the folder and `problem write` has not made them: its truth.json names the problem.
void check_folder(const ProblemWriteArguments& arguments) {
  std::error_code ignored;
  std::ifstream truth(arguments.directory / "truth.json");
  const std::string text{std::istreambuf_iterator<char>(truth), {}};
  const bool is_own = text.find("\"name\": \"" + arguments.name + "\"") != std::string::npos;
  if (is_own) return;
  for (const auto& entry : std::filesystem::directory_iterator(arguments.directory, ignored)) {
    const std::string name = entry.path().filename().string();
    const bool is_in_the_way = name == "truth.json" || name.starts_with(arguments.name + ".") || name.starts_with(arguments.name + "_");
    if (!is_in_the_way) continue;
    throw InputError({ErrorKind::usage, entry.path().string(), "", "would perhaps be replaced, and is not of problem " + arguments.name,
                      "name another folder"});
  }
}

}  // namespace

ExitCode execute(const ProblemWriteArguments& arguments, std::ostream& out) {
  check_folder(arguments);
  if (const auto* curve = problems::find_loading_curve(arguments.name)) {
    const auto file = problems::write(*curve, arguments.directory, arguments.options);
    out << "wrote " << file.string() << "\nnext: jointid loading-curve " << file.string() << ' ' << problems::fit_options(*curve) << '\n';
    return ExitCode::done;
  }
  if (problems::is_coupling(arguments.name)) {
    const auto scene = problems::write(problems::make_coupling(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << scene.string() << "\nnext: jointid couple " << scene.string() << '\n';
    return ExitCode::done;
  }
  if (problems::is_rig_two(arguments.name)) {
    const auto scene = problems::write(problems::make_rig_two(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << scene.string() << "\nnext: jointid equivalent " << scene.string() << " --csv joint.csv\n";
    return ExitCode::done;
  }
  if (problems::is_modal_set(arguments.name)) {
    const auto file = problems::write(problems::make_modal_set(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << file.string() << "\nnext: jointid modalfit " << file.string() << " --real --damping hysteretic\n";
    return ExitCode::done;
  }
  if (const auto* beams = problems::find_two_beams(arguments.name)) {
    const auto scene = problems::write(*beams, arguments.directory);
    out << "wrote " << scene.string() << "\nnext: jointid response " << scene.string() << '\n';
    return ExitCode::done;
  }
  if (const auto* pulse = problems::find_pulse(arguments.name)) {
    const auto scene = problems::write(*pulse, arguments.directory);
    out << "wrote " << scene.string() << "\nnext: jointid response " << scene.string() << " --history motion.csv\n";
    return ExitCode::done;
  }
  if (problems::is_law_problem(arguments.name)) {
    const auto scene = problems::write(problems::make_law_problem(arguments.name), arguments.directory, arguments.options);
    out << "wrote " << scene.string() << "\nnext: jointid solve " << scene.string() << '\n';
    return ExitCode::done;
  }
  if (const auto* oscillation = problems::find_oscillation(arguments.name)) {
    const auto scene = problems::write(*oscillation, arguments.directory);
    out << "wrote " << scene.string() << "\nnext: jointid oscillate " << scene.string() << " --report " << arguments.name << ".html\n";
    return ExitCode::done;
  }
  const auto problem = problems::make(arguments.name);
  const auto scene = problems::write(problem, arguments.directory, arguments.options);
  out << "wrote " << scene.string() << "\nnext: jointid solve " << scene.string() << '\n';
  return ExitCode::done;
}

}  // namespace jointid::cli
