#include "cli/problem/problem_command.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "base/temporary_file.hpp"
#include "cli/options/command_options.hpp"
#include "cli/options/complete_program.hpp"
#include "cli/options/whole_number.hpp"
#include "ident/scene/method_traits.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {

void declare_problem(CLI::App& app, Chosen& chosen, const ProblemKinds& kinds) {
  CLI::App* problem = app.add_subcommand("problem", "Built-in problems with known answers");
  problem->require_subcommand(1);
  problem->footer("Examples:\n  jointid problem list\n  jointid problem write A1 a1 --format uff");

  auto [list, listed] = add_command<ProblemListArguments>(*problem, chosen, "list", "List them");
  listed->kinds = kinds;
  list->footer("Example:\n  jointid problem list");

  auto [write, arguments] = add_command<ProblemWriteArguments>(*problem, chosen, "write",
                                                               "Write FRF files, scene and truth of a problem");
  arguments->kinds = kinds;
  write->add_option("NAME", arguments->name, "Name of the problem, as `jointid problem list` prints it")->required();
  write->add_option("DIR", arguments->directory, "Folder for the files; it is made if absent")->required();
  write->add_option("--format", arguments->options.format, "Format of the FRF files")
      ->check(CLI::IsMember({"h5", "uff"}))
      ->capture_default_str();
  add_whole_number(write, "--seed", arguments->options.seed, "Seed of the noise", {});
  write->add_option("--method", arguments->options.method, "Method in the scene, in place of the usual one of the problem")
      ->check(CLI::IsMember(ident::method_words()));
  write->add_flag("--clean", arguments->options.clean, "Write the FRFs without noise");
  write->footer("Example:\n  jointid problem write A1 a1 --seed 7");
}

bool is_elsewhere(const ProblemListArguments& arguments) { return !arguments.kinds.all && complete_program(); }

bool is_elsewhere(const ProblemWriteArguments& arguments) {
  return !arguments.kinds.all && !arguments.kinds.have(arguments.name) && complete_program();
}

ExitCode execute(const ProblemListArguments& arguments, std::ostream& out) {
  report::Table table({{"name", report::Align::left}, {"what", report::Align::left}});
  for (const problems::ProblemKind& kind : arguments.kinds.kinds) {
    for (const problems::ProblemInfo& problem : kind.list()) table.add({problem.name, problem.description});
  }
  out << table.text(0);
  if (!arguments.kinds.all) out << "for more of them, " << how_to_complete << '\n';
  return ExitCode::done;
}

namespace {

/// Throws InputError where files of that name are in the folder and `problem write` has not made them: its truth.json names the problem.
void check_folder(const ProblemWriteArguments& arguments) {
  std::error_code ignored;
  require_regular_file(arguments.directory / "truth.json");
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
  const problems::WrittenProblem written = arguments.kinds.write(arguments.name, arguments.directory, arguments.options);
  out << "wrote " << written.file.string() << "\nnext: jointid " << written.next << '\n';
  return ExitCode::done;
}

}  // namespace jointid::cli
